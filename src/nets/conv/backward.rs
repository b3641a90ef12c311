//! The backward pass of both layers on plain slices.
//!
//! With `C = im2col(x)` and the weights `W`, `conv_down` is `W C` and `conv_up` is `col2im(W^T x)`. The gradient with
//! respect to the input of either layer is therefore the other layer without its bias. The gradient with respect to the
//! weights is the product of the coarse images and the transposed columns of the fine ones (`weight_gradient` where the
//! layer is a direct convolution). Native only, used by `autodiff`: the page does not train.

use std::sync::Mutex;

use super::direct::DirectConv;
use super::forward::{Columns, Group, Layer};
use super::matmul::{Matrix, matmul};
use super::weight_gradient::WeightGradient;

/// Gradients of the loss with respect to the input, the weights and the bias of a layer.
pub(crate) struct Gradients {
    /// Zeros if it is not needed.
    pub x: Vec<f32>,
    pub weight: Vec<f32>,
    pub bias: Vec<f32>,
}

impl Layer<'_> {
    /// Returns the gradients of `conv_down` from its input, its output and the gradient `dy` with respect to its
    /// output. The gradient with respect to the input is computed only if `input_needs_it`.
    pub(crate) fn conv_down_backward(&self, x: &[f32], y: &[f32], dy: &[f32], input_needs_it: bool) -> Gradients {
        let geometry = &self.geometry;
        let mut dx = vec![0.0; x.len()];
        let zeros = vec![0.0; geometry.fine_channels];
        let ParameterGradients { weight, bias } =
            self.sum_over_groups(&mut dx, geometry.fine_len(), geometry.coarse_channels, |group, dx, gradients| {
                let range = group.coarse(geometry);
                let dy = relu_backward(&dy[range.clone()], Some(&y[range]));
                add_channel_sums(&mut gradients.bias, &dy, geometry.coarse_cells());
                let x = &x[group.fine(geometry)];
                if DirectConv::fits(geometry) {
                    let gradient = &mut gradients.weight;
                    WeightGradient { geometry, coarse: &dy, fine: x, gradient }.compute();
                    if input_needs_it {
                        self.direct(&zeros, false, &dy, dx).conv_up();
                    }
                    return;
                }
                let dy = self.channels_first(&dy, group.samples);
                let mut columns = Columns::im2col(geometry, x, group.samples);
                let dy = Matrix::new(&dy, geometry.coarse_channels, columns.count, columns.count);
                matmul(&mut gradients.weight, geometry.patch_len(), dy, columns.matrix(geometry).transposed());
                if input_needs_it {
                    matmul(&mut columns.data, columns.stride, self.matrix().transposed(), dy);
                    columns.col2im(geometry, dx);
                }
            });
        Gradients { x: dx, weight, bias }
    }

    /// Returns the gradients of `conv_up` from its input, its output if a ReLU follows, and the gradient `dy` with
    /// respect to its output.
    pub(crate) fn conv_up_backward(&self, x: &[f32], y: Option<&[f32]>, dy: &[f32]) -> Gradients {
        let geometry = &self.geometry;
        let channels = geometry.coarse_channels;
        let cells = geometry.coarse_cells();
        let mut dx = vec![0.0; x.len()];
        let zeros = vec![0.0; geometry.coarse_channels];
        let ParameterGradients { weight, bias } =
            self.sum_over_groups(&mut dx, geometry.coarse_len(), geometry.fine_channels, |group, dx, gradients| {
                let range = group.fine(geometry);
                let dy = relu_backward(&dy[range.clone()], y.map(|y| &y[range]));
                add_channel_sums(&mut gradients.bias, &dy, geometry.fine_cells());
                if DirectConv::fits(geometry) {
                    let x = &x[group.coarse(geometry)];
                    let gradient = &mut gradients.weight;
                    WeightGradient { geometry, coarse: x, fine: &dy, gradient }.compute();
                    self.direct(&zeros, false, &dy, dx).conv_down();
                    return;
                }
                let columns = Columns::im2col(geometry, &dy, group.samples);
                let x = self.channels_first(&x[group.coarse(geometry)], group.samples);
                let x = Matrix::new(&x, channels, columns.count, columns.count);
                matmul(&mut gradients.weight, geometry.patch_len(), x, columns.matrix(geometry).transposed());
                let mut sums = vec![0.0; dx.len()];
                matmul(&mut sums, columns.count, self.matrix(), columns.matrix(geometry));
                for (index, dx) in dx.chunks_exact_mut(cells).enumerate() {
                    let (sample, channel) = (index / channels, index % channels);
                    dx.copy_from_slice(&sums[channel * columns.count + sample * cells..][..cells]);
                }
            });
        Gradients { x: dx, weight, bias }
    }

    /// Calls `work` for every group and sums the gradients of the groups in order, so that the result does not depend
    /// on the number of cores. `out` has `len` values per sample, the bias one per channel.
    fn sum_over_groups(
        &self,
        out: &mut [f32],
        len: usize,
        channels: usize,
        work: impl Fn(Group, &mut [f32], &mut ParameterGradients) + Sync,
    ) -> ParameterGradients {
        let groups = Mutex::new(Vec::new());
        self.for_each_group(out, len, |group, out| {
            let mut gradients = ParameterGradients { weight: vec![0.0; self.weight.len()], bias: vec![0.0; channels] };
            work(group, out, &mut gradients);
            groups.lock().expect("no group panics").push((group.first, gradients));
        });
        let mut groups = groups.into_inner().expect("no group panics");
        groups.sort_by_key(|(first, _)| *first);
        let mut groups = groups.into_iter().map(|(_, gradients)| gradients);
        let mut total = groups.next().expect("a batch has samples");
        for group in groups {
            total.weight.iter_mut().zip(group.weight).for_each(|(sum, value)| *sum += value);
            total.bias.iter_mut().zip(group.bias).for_each(|(sum, value)| *sum += value);
        }
        total
    }
}

/// Gradients with respect to weights and bias, of one group or of all groups.
struct ParameterGradients {
    weight: Vec<f32>,
    bias: Vec<f32>,
}

/// Returns the gradient with respect to the input of a ReLU with output `y`; without a ReLU, the unchanged gradient.
fn relu_backward(dy: &[f32], y: Option<&[f32]>) -> Vec<f32> {
    match y {
        Some(y) => dy.iter().zip(y).map(|(dy, y)| if *y > 0.0 { *dy } else { 0.0 }).collect(),
        None => dy.to_vec(),
    }
}

/// Adds the sum over each channel of some samples.
fn add_channel_sums(sums: &mut [f32], images: &[f32], cells: usize) {
    let channels = sums.len();
    for (index, plane) in images.chunks_exact(cells).enumerate() {
        sums[index % channels] += plane.iter().sum::<f32>();
    }
}

#[cfg(test)]
mod tests {
    use super::super::im2col::Geometry;
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Step of the central difference. The layers are linear apart from the ReLU, so a long step is exact and rounds
    /// less.
    const STEP: f32 = 0.125;

    /// Both kernels, batches of one group and of several, the last of six columns, matrix products and direct
    /// convolutions.
    const CASES: [(Geometry, usize); 4] = [
        (Geometry { fine_channels: 3, coarse_channels: 8, coarse_side: 4, kernel: 4 }, 2),
        (Geometry { fine_channels: 8, coarse_channels: 16, coarse_side: 1, kernel: 2 }, 22),
        (Geometry { fine_channels: 8, coarse_channels: 16, coarse_side: 8, kernel: 4 }, 3),
        (Geometry { fine_channels: 5, coarse_channels: 8, coarse_side: 32, kernel: 4 }, 3),
    ];

    fn random(count: usize, rng: &mut Pcg64Mcg) -> Vec<f32> {
        (0..count).map(|_| rng.random_range(-1.0..1.0)).collect()
    }

    /// Returns the central difference of `f` in one of its values.
    fn central_difference(at: &[f32], index: usize, f: impl Fn(&[f32]) -> f64) -> f64 {
        let moved = |by: f32| {
            let mut at = at.to_vec();
            at[index] += by;
            f(&at)
        };
        (moved(STEP) - moved(-STEP)) / f64::from(2.0 * STEP)
    }

    fn assert_gradient(name: &str, found: &[f32], at: &[f32], f: impl Fn(&[f32]) -> f64) {
        assert_eq!(found.len(), at.len(), "{name}");
        let every = (at.len() / 40).max(1);
        for index in (0..at.len()).step_by(every) {
            let expected = central_difference(at, index, &f);
            let found = f64::from(found[index]);
            assert!(
                (found - expected).abs() < 2e-3 * (1.0 + expected.abs()),
                "{name} {index}: {found}, not {expected}"
            );
        }
    }

    fn dot(a: &[f32], b: &[f32]) -> f64 {
        a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
    }

    #[test]
    fn gradients_of_conv_down_are_difference_quotients() {
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        for (geometry, batch) in CASES {
            let x = random(batch * geometry.fine_len(), &mut rng);
            let weight = random(geometry.coarse_channels * geometry.patch_len(), &mut rng);
            // Every output stays on one side of the ReLU: half of the channels far above zero, half far below.
            let bias: Vec<f32> = (0..geometry.coarse_channels).map(|i| if i % 2 == 0 { 20.0 } else { -20.0 }).collect();
            let dy = random(batch * geometry.coarse_len(), &mut rng);
            let y = Layer { geometry, weight: &weight, fused: true }.conv_down(&x, &bias);
            let gradients = Layer { geometry, weight: &weight, fused: true }.conv_down_backward(&x, &y, &dy, true);
            let f = |x: &[f32], weight: &[f32], bias: &[f32]| {
                dot(&Layer { geometry, weight, fused: true }.conv_down(x, bias), &dy)
            };
            let offset = f(&x, &weight, &bias);
            assert!(offset != 0.0);
            assert_gradient("x", &gradients.x, &x, |x| f(x, &weight, &bias) - offset);
            assert_gradient("weight", &gradients.weight, &weight, |weight| f(&x, weight, &bias) - offset);
            assert_gradient("bias", &gradients.bias, &bias, |bias| f(&x, &weight, bias) - offset);
        }
    }

    #[test]
    fn gradients_of_conv_up_are_difference_quotients() {
        let mut rng = Pcg64Mcg::seed_from_u64(2);
        for (geometry, batch) in CASES {
            let x = random(batch * geometry.coarse_len(), &mut rng);
            let weight = random(geometry.coarse_channels * geometry.patch_len(), &mut rng);
            let bias: Vec<f32> = (0..geometry.fine_channels).map(|i| if i % 2 == 0 { 20.0 } else { -20.0 }).collect();
            let dy = random(batch * geometry.fine_len(), &mut rng);
            for relu in [true, false] {
                let layer = Layer { geometry, weight: &weight, fused: true };
                let y = layer.conv_up(&x, &bias, relu);
                let gradients = layer.conv_up_backward(&x, relu.then_some(&y[..]), &dy);
                let f = |x: &[f32], weight: &[f32], bias: &[f32]| {
                    dot(&Layer { geometry, weight, fused: true }.conv_up(x, bias, relu), &dy)
                };
                assert_gradient("x", &gradients.x, &x, |x| f(x, &weight, &bias));
                assert_gradient("weight", &gradients.weight, &weight, |weight| f(&x, weight, &bias));
                assert_gradient("bias", &gradients.bias, &bias, |bias| f(&x, &weight, bias));
            }
        }
    }
}
