//! Both layers as direct convolutions of 4 x 4 kernels, for coarse images of at least 8 x 8 cells.
//!
//! The sums of a tile, some output channels by some columns of a row, stay in registers. With stride 2, the taps of a
//! kernel row that meet the same phase (the even or the odd columns of the fine image) are neighbours in that phase.
//! Both layers are therefore sums over pairs of neighbouring taps, and the same tile serves both. `conv_down` reads the
//! fine image split into phases; `conv_up` computes each phase of the fine image from the coarse one and interleaves
//! them. Used by `forward` and `backward`.

use pulp::{Simd, WithSimd, bytemuck};

use super::im2col::Geometry;
use super::planes::Planes;
use super::simd::{lanes_that_divide, load, multiply_add, vectorize};

/// Output channels and registers of a tile. Together they make eight sums, as many as wasm has registers for besides
/// the factors.
const CHANNELS: usize = if cfg!(target_arch = "wasm32") { 4 } else { 8 };
const REGISTERS: usize = 8 / CHANNELS;

/// Registers of a tile of one output channel, with up to eight lanes: a row of 32 cells.
const ROW_REGISTERS: usize = if cfg!(target_arch = "wasm32") { 8 } else { 4 };

/// Widest coarse row in any net.
const WIDEST: usize = 32;

/// A layer with its input and output images, whose sizes are given by `geometry`.
pub(crate) struct DirectConv<'a> {
    pub geometry: &'a Geometry,
    /// `[coarse_channels, fine_channels, 4, 4]`.
    pub weight: &'a [f32],
    /// One value for each output channel.
    pub bias: &'a [f32],
    pub relu: bool,
    /// Whether to fuse multiplications with additions: in training only, see `simd`.
    pub fused: bool,
    /// Input images.
    pub x: &'a [f32],
    /// Output images.
    pub y: &'a mut [f32],
}

impl DirectConv<'_> {
    /// Returns whether the tiles fit a layer.
    pub(crate) fn fits(geometry: &Geometry) -> bool {
        let whole = |channels: usize| channels.is_multiple_of(8);
        geometry.kernel == 4
            && geometry.coarse_side.is_multiple_of(8)
            && whole(geometry.coarse_channels)
            && (whole(geometry.fine_channels) || geometry.coarse_side == WIDEST)
    }

    /// Computes coarse images from fine ones.
    pub(crate) fn conv_down(self) {
        let lanes = lanes_that_divide(self.geometry.coarse_side);
        // Only training fuses, so the page's wasm does without that code.
        if cfg!(feature = "training") && self.fused {
            vectorize(lanes, ConvDown::<true>(self));
        } else {
            vectorize(lanes, ConvDown::<false>(self));
        }
    }

    /// Computes fine images from coarse ones.
    pub(crate) fn conv_up(self) {
        let lanes = lanes_that_divide(self.geometry.coarse_side);
        if cfg!(feature = "training") && self.fused {
            vectorize(lanes, ConvUp::<true>(self));
        } else {
            vectorize(lanes, ConvUp::<false>(self));
        }
    }
}

struct ConvDown<'a, const FUSED: bool>(DirectConv<'a>);

impl<const FUSED: bool> WithSimd for ConvDown<'_, FUSED> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let DirectConv { geometry, weight, bias, relu, x, y, .. } = self.0;
        let side = geometry.coarse_side;
        let taps = 16 * geometry.fine_channels;
        let images: Vec<Planes> = x
            .chunks_exact(geometry.fine_len())
            .map(|image| Planes::with_phases(image, geometry.fine_channels, side))
            .collect();
        let offsets = images.first().expect("a group has samples").pairs_of_taps();
        let mut packed = vec![[[[0.0; CHANNELS]; 2]; 8]; geometry.fine_channels];
        let epilogue = Epilogue::new(simd, relu);
        for first in (0..geometry.coarse_channels).step_by(CHANNELS) {
            for (index, weight) in weight[first * taps..].chunks_exact(taps).take(CHANNELS).enumerate() {
                for (pairs, kernel) in packed.iter_mut().zip(kernels(weight)) {
                    for (pair, [left, right]) in pairs.iter_mut().enumerate() {
                        let (row, phase) = (pair / 2, pair % 2);
                        left[index] = kernel[row][phase];
                        right[index] = kernel[row][phase + 2];
                    }
                }
            }
            for (planes, y) in images.iter().zip(y.chunks_exact_mut(geometry.coarse_len())) {
                let y = &mut y[first * geometry.coarse_cells()..];
                for row in 0..side {
                    for column in (0..side).step_by(REGISTERS * S::F32_LANES) {
                        let at = 2 * row * planes.row + column;
                        let sums = tile::<S, FUSED, REGISTERS, CHANNELS, 8>(simd, planes, at, &offsets, &packed);
                        let cells = y.chunks_exact_mut(geometry.coarse_cells());
                        for ((sums, bias), y) in sums.iter().zip(&bias[first..]).zip(cells) {
                            let y = &mut y[row * side + column..][..REGISTERS * S::F32_LANES];
                            for (y, sum) in S::as_mut_simd_f32s(y).0.iter_mut().zip(sums) {
                                *y = epilogue.apply(simd, *sum, *bias);
                            }
                        }
                    }
                }
            }
        }
    }
}

struct ConvUp<'a, const FUSED: bool>(DirectConv<'a>);

impl<const FUSED: bool> WithSimd for ConvUp<'_, FUSED> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        if self.0.geometry.fine_channels.is_multiple_of(CHANNELS) {
            conv_up::<S, FUSED, REGISTERS, CHANNELS>(simd, self.0);
        } else if S::F32_LANES == 16 {
            conv_up::<S, FUSED, 2, 1>(simd, self.0);
        } else {
            conv_up::<S, FUSED, ROW_REGISTERS, 1>(simd, self.0);
        }
    }
}

#[inline(always)]
fn conv_up<S: Simd, const FUSED: bool, const REGISTERS: usize, const CHANNELS: usize>(simd: S, layer: DirectConv) {
    let DirectConv { geometry, weight, bias, relu, x, y, .. } = layer;
    let side = geometry.coarse_side;
    let images: Vec<Planes> =
        x.chunks_exact(geometry.coarse_len()).map(|image| Planes::new(image, geometry.coarse_channels, side)).collect();
    let offsets = [0, images.first().expect("a group has samples").row];
    // One entry per phase of the fine image, rows before columns.
    let mut packed: [_; 4] = std::array::from_fn(|_| vec![[[[0.0; CHANNELS]; 2]; 2]; geometry.coarse_channels]);
    let epilogue = Epilogue::new(simd, relu);
    for first in (0..geometry.fine_channels).step_by(CHANNELS) {
        for (phase, packed) in packed.iter_mut().enumerate() {
            let rows = taps_of_phase(phase / 2);
            let columns = taps_of_phase(phase % 2);
            for (pairs, weight) in packed.iter_mut().zip(weight.chunks_exact(16 * geometry.fine_channels)) {
                for (index, kernel) in kernels(weight)[first..first + CHANNELS].iter().enumerate() {
                    for ([left, right], row) in pairs.iter_mut().zip(rows) {
                        left[index] = kernel[row][columns[0]];
                        right[index] = kernel[row][columns[1]];
                    }
                }
            }
        }
        for (planes, y) in images.iter().zip(y.chunks_exact_mut(geometry.fine_len())) {
            let y = &mut y[first * geometry.fine_cells()..];
            for fine_row in 0..2 * side {
                let row = fine_row / 2;
                let phase = fine_row % 2;
                for column in (0..side).step_by(REGISTERS * S::F32_LANES) {
                    let at = (row + phase) * planes.row + column;
                    let packed = &packed[2 * phase..];
                    let even = tile::<S, FUSED, REGISTERS, CHANNELS, 2>(simd, planes, at, &offsets, &packed[0]);
                    let odd = tile::<S, FUSED, REGISTERS, CHANNELS, 2>(simd, planes, at + 1, &offsets, &packed[1]);
                    let cells = y.chunks_exact_mut(geometry.fine_cells());
                    for (((even, odd), bias), y) in even.iter().zip(&odd).zip(&bias[first..]).zip(cells) {
                        let y = &mut y[fine_row * 2 * side + 2 * column..][..2 * REGISTERS * S::F32_LANES];
                        for ((y, even), odd) in y.chunks_exact_mut(2 * S::F32_LANES).zip(even).zip(odd) {
                            let even = [epilogue.apply(simd, *even, *bias)];
                            let odd = [epilogue.apply(simd, *odd, *bias)];
                            interleave(y, bytemuck::cast_slice(&even), bytemuck::cast_slice(&odd));
                        }
                    }
                }
            }
        }
    }
}

/// Returns the 4 x 4 kernels of some weights, row by row.
#[inline(always)]
fn kernels(weight: &[f32]) -> &[[[f32; 4]; 4]] {
    weight.as_chunks::<4>().0.as_chunks::<4>().0
}

/// Returns the taps of `conv_up` that reach the even fine cells (phase 0) or the odd ones (phase 1) of a row or column,
/// in the order of the coarse cells that they are multiplied with. A coarse cell spreads over four fine cells, from the
/// one before its own two to the one after them:
///
/// ```text
/// fine cells            2i-1   2i   2i+1  2i+2
/// tap of coarse i-1      2      3
/// tap of coarse i        0      1     2     3
/// tap of coarse i+1                   0     1
/// ```
///
/// So the even cell 2i receives coarse i-1 by tap 3 and coarse i by tap 1; the odd cell 2i+1 receives coarse i by tap 2
/// and coarse i+1 by tap 0.
#[inline(always)]
fn taps_of_phase(phase: usize) -> [usize; 2] {
    [3 - phase, 1 - phase]
}

#[inline(always)]
fn interleave(to: &mut [f32], even: &[f32], odd: &[f32]) {
    for ((pair, even), odd) in to.as_chunks_mut::<2>().0.iter_mut().zip(even).zip(odd) {
        *pair = [*even, *odd];
    }
}

/// Returns the sums of `REGISTERS` registers of neighbouring columns in `CHANNELS` output channels. For each input
/// channel, a pair of taps covers the cells from its offset onwards and their right neighbours; `weights` are
/// `[input channels][pairs][left, right][output channels]`.
#[inline(always)]
fn tile<S: Simd, const FUSED: bool, const REGISTERS: usize, const CHANNELS: usize, const PAIRS: usize>(
    simd: S,
    planes: &Planes,
    at: usize,
    offsets: &[usize; PAIRS],
    weights: &[[[[f32; CHANNELS]; 2]; PAIRS]],
) -> [[S::f32s; REGISTERS]; CHANNELS] {
    let mut sums = [[simd.splat_f32s(0.0); REGISTERS]; CHANNELS];
    for (plane, pairs) in planes.data.chunks_exact(planes.len).zip(weights) {
        for (offset, taps) in offsets.iter().zip(pairs) {
            let cells = &plane[at + offset..][..REGISTERS * S::F32_LANES + 1];
            let left: [_; REGISTERS] = std::array::from_fn(|index| load::<S>(cells, index * S::F32_LANES));
            for channel in 0..CHANNELS {
                multiply_add::<S, FUSED, REGISTERS>(simd, &mut sums[channel], taps[0][channel], left);
            }
            let right: [_; REGISTERS] = std::array::from_fn(|index| load::<S>(cells, index * S::F32_LANES + 1));
            for channel in 0..CHANNELS {
                multiply_add::<S, FUSED, REGISTERS>(simd, &mut sums[channel], taps[1][channel], right);
            }
        }
    }
    sums
}

/// The steps after the sums of a layer: its bias and, if there is one, its ReLU.
struct Epilogue<S: Simd> {
    least: S::f32s,
}

impl<S: Simd> Epilogue<S> {
    #[inline(always)]
    fn new(simd: S, relu: bool) -> Epilogue<S> {
        Epilogue { least: simd.splat_f32s(if relu { 0.0 } else { f32::NEG_INFINITY }) }
    }

    #[inline(always)]
    fn apply(&self, simd: S, sum: S::f32s, bias: f32) -> S::f32s {
        simd.max_f32s(simd.add_f32s(sum, simd.splat_f32s(bias)), self.least)
    }
}

#[cfg(test)]
mod tests {
    use pulp::Scalar128b;

    use super::*;

    fn values(count: usize) -> Vec<f32> {
        (0..count).map(|i| ((i * 37 % 101) as f32 - 50.0) / 77.0).collect()
    }

    /// Proposals must be the same on every machine and in wasm, whose registers have four lanes.
    #[test]
    fn the_number_of_lanes_changes_no_bit() {
        for (fine_channels, coarse_side) in [(5, 32), (8, 16), (16, 8)] {
            let geometry = &Geometry { fine_channels, coarse_channels: 16, coarse_side, kernel: 4 };
            let (coarse, fine) = (values(geometry.coarse_len()), values(geometry.fine_len()));
            let (weight, bias) = (values(16 * 16 * fine_channels), values(16));
            let layer = |x, y| DirectConv { geometry, weight: &weight, bias: &bias, relu: true, fused: false, x, y };
            let [mut wide, mut narrow] = [(); 2].map(|()| (vec![0.0; coarse.len()], vec![0.0; fine.len()]));
            layer(&fine, &mut wide.0).conv_down();
            layer(&coarse, &mut wide.1).conv_up();
            Simd::vectorize(Scalar128b, ConvDown::<false>(layer(&fine, &mut narrow.0)));
            Simd::vectorize(Scalar128b, ConvUp::<false>(layer(&coarse, &mut narrow.1)));
            assert!(wide == narrow, "{fine_channels} channels, {coarse_side} cells");
            assert!(wide.0.iter().chain(&wide.1).filter(|&&y| y > 0.0).count() > 1000);
        }
    }
}
