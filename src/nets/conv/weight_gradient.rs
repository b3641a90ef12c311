//! The gradient of the loss with respect to the weights of a layer, computed on the planes of the direct convolutions.
//!
//! For both layers it is the correlation of coarse images with fine ones: for `conv_down`, of the output's gradient
//! with the input; for `conv_up`, of the input with the output's gradient. Native only; used by `backward`.

use pulp::{Simd, WithSimd};

use super::im2col::Geometry;
use super::planes::Planes;
use super::simd::{lanes_that_divide, load, vectorize};

/// The images of some samples, and the destination of the gradient `[coarse_channels, fine_channels, 4, 4]`. The layer
/// must satisfy `DirectConv::fits`.
pub(crate) struct WeightGradient<'a> {
    pub geometry: &'a Geometry,
    pub coarse: &'a [f32],
    pub fine: &'a [f32],
    pub gradient: &'a mut [f32],
}

impl WeightGradient<'_> {
    pub(crate) fn compute(self) {
        vectorize(lanes_that_divide(self.geometry.coarse_side), self);
    }
}

impl WithSimd for WeightGradient<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        // Each channel takes two registers of sums, one for each tap: together half of all registers.
        if S::F32_LANES == 16 { weight_gradient::<S, 8>(simd, self) } else { weight_gradient::<S, 4>(simd, self) }
    }
}

/// Correlates `CHANNELS` coarse channels with a pair of taps at once.
#[inline(always)]
fn weight_gradient<S: Simd, const CHANNELS: usize>(simd: S, layer: WeightGradient) {
    let WeightGradient { geometry, coarse, fine, gradient } = layer;
    let side = geometry.coarse_side;
    let images: Vec<Planes> = fine
        .chunks_exact(geometry.fine_len())
        .map(|image| Planes::with_phases(image, geometry.fine_channels, side))
        .collect();
    let pairs = images.first().expect("a group has samples").pairs_of_taps();
    let taps = 16 * geometry.fine_channels;
    for (block, gradient) in gradient.chunks_exact_mut(CHANNELS * taps).enumerate() {
        let block = block * CHANNELS * geometry.coarse_cells()..;
        for fine_channel in 0..geometry.fine_channels {
            for (pair, offset) in pairs.iter().enumerate() {
                let mut sums = [[simd.splat_f32s(0.0); 2]; CHANNELS];
                for (planes, coarse) in images.iter().zip(coarse.chunks_exact(geometry.coarse_len())) {
                    let plane = &planes.data[fine_channel * planes.len + offset..];
                    correlate::<S, CHANNELS>(simd, &mut sums, &coarse[block.clone()], plane, side, 2 * planes.row);
                }
                for (sums, gradient) in sums.iter().zip(gradient.chunks_exact_mut(taps)) {
                    let tap = 16 * fine_channel + pair / 2 * 4 + pair % 2;
                    gradient[tap] = simd.reduce_sum_f32s(sums[0]);
                    gradient[tap + 2] = simd.reduce_sum_f32s(sums[1]);
                }
            }
        }
    }
}

/// Adds the products of coarse images, `[CHANNELS, side, side]`, with the cells that a pair of taps meets. The cells of
/// consecutive coarse rows are `stride` values apart.
#[inline(always)]
fn correlate<S: Simd, const CHANNELS: usize>(
    simd: S,
    sums: &mut [[S::f32s; 2]; CHANNELS],
    coarse: &[f32],
    fine: &[f32],
    side: usize,
    stride: usize,
) {
    let channels: [&[f32]; CHANNELS] = std::array::from_fn(|channel| &coarse[channel * side * side..][..side * side]);
    for row in 0..side {
        let fine = &fine[row * stride..][..=side];
        for column in (0..side).step_by(S::F32_LANES) {
            let fine = [load::<S>(fine, column), load::<S>(fine, column + 1)];
            for channel in 0..CHANNELS {
                let coarse = load::<S>(channels[channel], row * side + column);
                for tap in 0..2 {
                    sums[channel][tap] = simd.mul_add_e_f32s(coarse, fine[tap], sums[channel][tap]);
                }
            }
        }
    }
}
