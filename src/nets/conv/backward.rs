//! The gradients of the two operations, and how burn's autodiff learns of them.
//!
//! With `c` the gathered patches of the wide picture and `w` the weights, halving is `w c` and doubling scatters
//! `w' x`; so each one's gradient by its input is the other without its bias, and the gradient by the weights is
//! the product of the narrow side and the patches. Native only: the page does not train.

use burn::backend::autodiff::NodeId;
use burn::backend::autodiff::checkpoint::base::Checkpointer;
use burn::backend::autodiff::checkpoint::strategy::CheckpointStrategy;
use burn::backend::autodiff::grads::Gradients;
use burn::backend::autodiff::ops::{Backward, Ops, OpsKind};
use burn::backend::tensor::FloatTensor;
use burn::backend::{Autodiff, Flex, TensorMetadata};
use burn::tensor::TensorData;
use std::sync::Mutex;

use super::forward::{Columns, Group, Layer};
use super::matmul::{Matrix, product};
use super::{StridedOps, geometry, numbers};

/// What the input, the weights and the bias of a layer would have to change by.
struct Slopes {
    x: Vec<f32>,
    weight: Vec<f32>,
    bias: Vec<f32>,
}

impl Layer<'_> {
    /// Of `halve`: from its input, its output and the slope of its output.
    fn halve_back(&self, x: &[f32], y: &[f32], slope: &[f32]) -> Slopes {
        let geometry = self.geometry;
        let cells = geometry.cells();
        let mut dx = vec![0.0; x.len()];
        let (weight, bias) = self.summed(
            &mut dx,
            geometry.wide_picture(),
            |group, dx, part| {
                let range = group.narrow(&geometry);
                let passed = passed(&slope[range.clone()], Some(&y[range]));
                add_channels(&mut part.bias, &passed, cells);
                let passed = self.channels_first(&passed, group.samples);
                let mut columns = Columns::gathered(&geometry, &x[group.wide(&geometry)], group.samples);
                let passed = Matrix::new(&passed, geometry.narrow, columns.count, columns.count);
                product(&mut part.weight, geometry.patch(), passed, columns.matrix(&geometry).transposed());
                product(&mut columns.data, columns.stride, self.matrix().transposed(), passed);
                columns.scatter(&geometry, dx);
            },
            geometry.narrow,
        );
        Slopes { x: dx, weight, bias }
    }

    /// Of `double`: from its input, its output (where that is cut off below zero) and the slope of its output.
    fn double_back(&self, x: &[f32], y: Option<&[f32]>, slope: &[f32]) -> Slopes {
        let geometry = self.geometry;
        let cells = geometry.cells();
        let mut dx = vec![0.0; x.len()];
        let (weight, bias) = self.summed(
            &mut dx,
            geometry.narrow_picture(),
            |group, dx, part| {
                let range = group.wide(&geometry);
                let passed = passed(&slope[range.clone()], y.map(|y| &y[range]));
                add_channels(&mut part.bias, &passed, geometry.wide_cells());
                let columns = Columns::gathered(&geometry, &passed, group.samples);
                let x = self.channels_first(&x[group.narrow(&geometry)], group.samples);
                let x = Matrix::new(&x, geometry.narrow, columns.count, columns.count);
                product(&mut part.weight, geometry.patch(), x, columns.matrix(&geometry).transposed());
                let mut sums = vec![0.0; dx.len()];
                product(&mut sums, columns.count, self.matrix(), columns.matrix(&geometry));
                for (index, dx) in dx.chunks_exact_mut(cells).enumerate() {
                    let (sample, channel) = (index / geometry.narrow, index % geometry.narrow);
                    dx.copy_from_slice(&sums[channel * columns.count + sample * cells..][..cells]);
                }
            },
            geometry.wide,
        );
        Slopes { x: dx, weight, bias }
    }

    /// Calls `work` for every group, and sums up the parts that the groups give, in their order, so that the
    /// result does not hang on the number of cores.
    fn summed(
        &self,
        out: &mut [f32],
        size: usize,
        work: impl Fn(Group, &mut [f32], &mut Part) + Sync,
        channels: usize,
    ) -> (Vec<f32>, Vec<f32>) {
        let parts = Mutex::new(Vec::new());
        self.each_group(out, size, |group, out| {
            let mut part = Part { weight: vec![0.0; self.weight.len()], bias: vec![0.0; channels] };
            work(group, out, &mut part);
            parts.lock().expect("no group panics").push((group.first, part));
        });
        let mut parts = parts.into_inner().expect("no group panics");
        parts.sort_by_key(|(first, _)| *first);
        let mut parts = parts.into_iter().map(|(_, part)| part);
        let Part { mut weight, mut bias } = parts.next().expect("a batch has samples");
        for part in parts {
            weight.iter_mut().zip(part.weight).for_each(|(sum, one)| *sum += one);
            bias.iter_mut().zip(part.bias).for_each(|(sum, one)| *sum += one);
        }
        (weight, bias)
    }
}

/// The slopes that one group gives.
struct Part {
    weight: Vec<f32>,
    bias: Vec<f32>,
}

/// The slope that passes the relu: where the output is zero, none.
fn passed(slope: &[f32], y: Option<&[f32]>) -> Vec<f32> {
    match y {
        Some(y) => slope.iter().zip(y).map(|(slope, y)| if *y > 0.0 { *slope } else { 0.0 }).collect(),
        None => slope.to_vec(),
    }
}

/// Adds the sum of every channel of some samples.
fn add_channels(sums: &mut [f32], pictures: &[f32], cells: usize) {
    let channels = sums.len();
    for (index, plane) in pictures.chunks_exact(cells).enumerate() {
        sums[index % channels] += plane.iter().sum::<f32>();
    }
}

#[derive(Debug)]
struct Halve;

#[derive(Debug)]
struct Double {
    positive: bool,
}

/// Input, weights and output of a layer.
type Kept = [FloatTensor<Flex>; 3];

impl Backward<Flex, 3> for Halve {
    type State = Kept;

    fn backward(self, ops: Ops<Kept, 3>, grads: &mut Gradients, _: &mut Checkpointer) {
        let slope = grads.consume::<Flex>(&ops.node);
        let [x, weight, y] = &ops.state;
        let geometry = geometry(weight, y.shape()[2]);
        let slopes = numbers(weight, |weight| {
            numbers(x, |x| numbers(y, |y| numbers(&slope, |slope| Layer { geometry, weight }.halve_back(x, y, slope))))
        });
        register(ops.parents.map(|parent| parent.map(|node| node.id)), &ops.state, slopes, grads);
    }
}

impl Backward<Flex, 3> for Double {
    type State = Kept;

    fn backward(self, ops: Ops<Kept, 3>, grads: &mut Gradients, _: &mut Checkpointer) {
        let slope = grads.consume::<Flex>(&ops.node);
        let [x, weight, y] = &ops.state;
        let geometry = geometry(weight, x.shape()[2]);
        let slopes = numbers(weight, |weight| {
            numbers(x, |x| {
                numbers(y, |y| {
                    let y = self.positive.then_some(y);
                    numbers(&slope, |slope| Layer { geometry, weight }.double_back(x, y, slope))
                })
            })
        });
        register(ops.parents.map(|parent| parent.map(|node| node.id)), &ops.state, slopes, grads);
    }
}

/// Hands the slopes to those of the three parents that ask for them.
fn register(parents: [Option<NodeId>; 3], [x, weight, _]: &Kept, slopes: Slopes, grads: &mut Gradients) {
    let shaped = |numbers: Vec<f32>, shape: &FloatTensor<Flex>| {
        FloatTensor::<Flex>::from_data(TensorData::new(numbers, shape.shape()))
    };
    let [for_x, for_weight, for_bias] = parents;
    if let Some(id) = for_x {
        grads.register::<Flex>(id, shaped(slopes.x, x));
    }
    if let Some(id) = for_weight {
        grads.register::<Flex>(id, shaped(slopes.weight, weight));
    }
    if let Some(id) = for_bias {
        let channels = slopes.bias.len();
        grads.register::<Flex>(id, FloatTensor::<Flex>::from_data(TensorData::new(slopes.bias, [channels])));
    }
}

impl<C: CheckpointStrategy> StridedOps for Autodiff<Flex, C> {
    fn halve(x: FloatTensor<Self>, weight: FloatTensor<Self>, bias: FloatTensor<Self>) -> FloatTensor<Self> {
        let y = Flex::halve(x.primitive().clone(), weight.primitive().clone(), bias.primitive().clone());
        let nodes = [x.node(), weight.node(), bias.node()];
        match Halve.prepare::<C>(nodes).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish([x.primitive().clone(), weight.primitive().clone(), y.clone()], y),
            OpsKind::UnTracked(step) => step.finish(y),
        }
    }

    fn double(
        x: FloatTensor<Self>,
        weight: FloatTensor<Self>,
        bias: FloatTensor<Self>,
        positive: bool,
    ) -> FloatTensor<Self> {
        let y = Flex::double(x.primitive().clone(), weight.primitive().clone(), bias.primitive().clone(), positive);
        let nodes = [x.node(), weight.node(), bias.node()];
        match (Double { positive }).prepare::<C>(nodes).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish([x.primitive().clone(), weight.primitive().clone(), y.clone()], y),
            OpsKind::UnTracked(step) => step.finish(y),
        }
    }
}

/// On ndarray burn differentiates its own operations: the second opinion.
#[cfg(feature = "ndarray")]
impl<C: CheckpointStrategy> StridedOps for Autodiff<burn::backend::NdArray, C> {}

#[cfg(test)]
mod tests {
    use super::super::im2col::Geometry;
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The step of a difference quotient. The layers are linear but for relu, so a long one is as good and rounds less.
    const STEP: f32 = 0.125;

    fn numbers(count: usize, rng: &mut Pcg64Mcg) -> Vec<f32> {
        (0..count).map(|_| rng.random_range(-1.0..1.0)).collect()
    }

    /// The slope of `f` along one of its numbers.
    fn difference(at: &[f32], index: usize, f: impl Fn(&[f32]) -> f64) -> f64 {
        let moved = |by: f32| {
            let mut at = at.to_vec();
            at[index] += by;
            f(&at)
        };
        (moved(STEP) - moved(-STEP)) / f64::from(2.0 * STEP)
    }

    fn assert_slopes(name: &str, found: &[f32], at: &[f32], f: impl Fn(&[f32]) -> f64) {
        assert_eq!(found.len(), at.len(), "{name}");
        let every = (at.len() / 40).max(1);
        for index in (0..at.len()).step_by(every) {
            let wanted = difference(at, index, &f);
            let found = f64::from(found[index]);
            assert!((found - wanted).abs() < 2e-3 * (1.0 + wanted.abs()), "{name} {index}: {found}, not {wanted}");
        }
    }

    fn dot(a: &[f32], b: &[f32]) -> f64 {
        a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
    }

    /// Both kernels, and batches of one group and of several.
    const CASES: [(Geometry, usize); 3] = [
        (Geometry { wide: 3, narrow: 8, side: 4, kernel: 4 }, 2),
        (Geometry { wide: 8, narrow: 16, side: 1, kernel: 2 }, 20),
        (Geometry { wide: 5, narrow: 8, side: 32, kernel: 4 }, 3),
    ];

    #[test]
    fn slopes_of_halving_are_difference_quotients() {
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        for (geometry, batch) in CASES {
            let (x, weight) = (
                numbers(batch * geometry.wide_picture(), &mut rng),
                numbers(geometry.narrow * geometry.patch(), &mut rng),
            );
            // Every output stays on one side of the relu: half of the channels far above, half far below zero.
            let bias: Vec<f32> = (0..geometry.narrow).map(|i| if i % 2 == 0 { 20.0 } else { -20.0 }).collect();
            let slope = numbers(batch * geometry.narrow_picture(), &mut rng);
            let y = Layer { geometry, weight: &weight }.halve(&x, &bias);
            let slopes = Layer { geometry, weight: &weight }.halve_back(&x, &y, &slope);
            let f = |x: &[f32], weight: &[f32], bias: &[f32]| dot(&Layer { geometry, weight }.halve(x, bias), &slope);
            let far = f(&x, &weight, &bias);
            assert!(far != 0.0);
            assert_slopes("x", &slopes.x, &x, |x| f(x, &weight, &bias) - far);
            assert_slopes("weight", &slopes.weight, &weight, |weight| f(&x, weight, &bias) - far);
            assert_slopes("bias", &slopes.bias, &bias, |bias| f(&x, &weight, bias) - far);
        }
    }

    #[test]
    fn slopes_of_doubling_are_difference_quotients() {
        let mut rng = Pcg64Mcg::seed_from_u64(2);
        for (geometry, batch) in CASES {
            let (x, weight) = (
                numbers(batch * geometry.narrow_picture(), &mut rng),
                numbers(geometry.narrow * geometry.patch(), &mut rng),
            );
            let bias: Vec<f32> = (0..geometry.wide).map(|i| if i % 2 == 0 { 20.0 } else { -20.0 }).collect();
            let slope = numbers(batch * geometry.wide_picture(), &mut rng);
            for positive in [true, false] {
                let layer = Layer { geometry, weight: &weight };
                let y = layer.double(&x, &bias, positive);
                let slopes = layer.double_back(&x, positive.then_some(&y[..]), &slope);
                let f = |x: &[f32], weight: &[f32], bias: &[f32]| {
                    dot(&Layer { geometry, weight }.double(x, bias, positive), &slope)
                };
                assert_slopes("x", &slopes.x, &x, |x| f(x, &weight, &bias));
                assert_slopes("weight", &slopes.weight, &weight, |weight| f(&x, weight, &bias));
                assert_slopes("bias", &slopes.bias, &bias, |bias| f(&x, &weight, bias));
            }
        }
    }
}
