//! The gradient of the loss with respect to the weights of a layer, computed on the planes of the direct convolutions.
//!
//! For both layers it is the correlation of coarse images with fine ones: for `conv_down`, of the output's gradient
//! with the input; for `conv_up`, of the input with the output's gradient. Native only; used by `backward`.

use pulp::{Simd, WithSimd};

use super::im2col::Geometry;
use super::planes::Planes;
use super::simd::{lanes_that_divide, vectorize};

/// Coarse channels to correlate with a pair of taps at once: eight sums.
const CHANNELS: usize = 4;

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
        let WeightGradient { geometry, coarse, fine, gradient } = self;
        let side = geometry.coarse_side;
        let mut images = Vec::new();
        for image in fine.chunks_exact(geometry.fine_len()) {
            let mut planes = Planes::with_phases(geometry.fine_channels, side);
            planes.fill_with_phases(image, side);
            images.push(planes);
        }
        let pairs = images.first().expect("a group has samples").pairs_of_taps();
        let taps = 16 * geometry.fine_channels;
        for (block, gradient) in gradient.chunks_exact_mut(CHANNELS * taps).enumerate() {
            let block = block * CHANNELS * geometry.coarse_cells()..;
            for fine_channel in 0..geometry.fine_channels {
                for (pair, offset) in pairs.iter().enumerate() {
                    let mut sums = [[simd.splat_f32s(0.0); 2]; CHANNELS];
                    for (planes, coarse) in images.iter().zip(coarse.chunks_exact(geometry.coarse_len())) {
                        let plane = &planes.data[fine_channel * planes.len + offset..];
                        correlate::<S>(simd, &mut sums, &coarse[block.clone()], plane, side, 2 * planes.row);
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
}

/// Adds the products of coarse images, `[CHANNELS, side, side]`, with the cells that a pair of taps meets. The cells of
/// consecutive coarse rows are `stride` values apart.
#[inline(always)]
fn correlate<S: Simd>(
    simd: S,
    sums: &mut [[S::f32s; 2]; CHANNELS],
    coarse: &[f32],
    fine: &[f32],
    side: usize,
    stride: usize,
) {
    let cells = side * side;
    let rows = |channel: usize| coarse[channel * cells..][..cells].chunks_exact(side);
    let rows = rows(0).zip(rows(1)).zip(rows(2)).zip(rows(3));
    for (fine, (((first, second), third), fourth)) in fine.chunks(stride).zip(rows) {
        let registers = |values| S::as_simd_f32s(values).0.iter();
        let coarse = registers(first).zip(registers(second)).zip(registers(third)).zip(registers(fourth));
        for ((left, right), (((first, second), third), fourth)) in
            registers(&fine[..side]).zip(registers(&fine[1..=side])).zip(coarse)
        {
            for (sums, coarse) in sums.iter_mut().zip([first, second, third, fourth]) {
                sums[0] = simd.mul_add_e_f32s(*coarse, *left, sums[0]);
                sums[1] = simd.mul_add_e_f32s(*coarse, *right, sums[1]);
            }
        }
    }
}
