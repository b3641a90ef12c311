//! The forward pass of one layer on plain slices.
//!
//! The batch is divided into groups of samples, small enough for their columns to stay in the cache. Images are
//! `[samples, channels, side, side]`; within a group the coarse ones become a matrix `[channels, samples * cells]`.

#[cfg(not(target_arch = "wasm32"))]
use rayon::prelude::*;

use super::direct::DirectConv;
use super::im2col::Geometry;
use super::matmul::{Matrix, matmul};

/// Values in the columns of a group: 256 KiB, which fit into a second-level cache.
const GROUP_LEN: usize = 1 << 16;

/// Most samples in a group, so that a batch of 32 keeps two cores busy.
const MAX_GROUP: usize = 16;

/// Most samples in a group of direct convolutions, which need no columns. The weights are packed once per group.
const DIRECT_GROUP: usize = 4;

/// A layer with its weights, `[coarse_channels, fine_channels, kernel, kernel]`.
#[derive(Clone, Copy)]
pub(crate) struct Layer<'a> {
    pub geometry: Geometry,
    pub weight: &'a [f32],
    /// See `DirectConv::fused`.
    pub fused: bool,
}

impl Layer<'_> {
    /// Convolution, bias and ReLU: `[batch, fine_channels, 2 n, 2 n]` to `[batch, coarse_channels, n, n]`.
    pub(crate) fn conv_down(&self, x: &[f32], bias: &[f32]) -> Vec<f32> {
        let geometry = &self.geometry;
        let channels = geometry.coarse_channels;
        let cells = geometry.coarse_cells();
        let batch = x.len() / geometry.fine_len();
        let mut y = vec![0.0; batch * geometry.coarse_len()];
        self.for_each_group(&mut y, geometry.coarse_len(), |group, y| {
            if DirectConv::fits(geometry) {
                let x = &x[group.fine(geometry)];
                self.direct(bias, true, x, y).conv_down();
                return;
            }
            let columns = Columns::im2col(geometry, &x[group.fine(geometry)], group.samples);
            let mut sums = vec![0.0; channels * columns.count];
            matmul(&mut sums, columns.count, self.matrix(), columns.matrix(geometry));
            for (index, y) in y.chunks_exact_mut(cells).enumerate() {
                let (sample, channel) = (index / channels, index % channels);
                let sums = &sums[channel * columns.count + sample * cells..][..cells];
                for (y, sum) in y.iter_mut().zip(sums) {
                    *y = at_least(sum + bias[channel], 0.0);
                }
            }
        });
        y
    }

    /// Transposed convolution, bias, and ReLU if `relu`: `[batch, coarse_channels, n, n]` to
    /// `[batch, fine_channels, 2 n, 2 n]`.
    pub(crate) fn conv_up(&self, x: &[f32], bias: &[f32], relu: bool) -> Vec<f32> {
        let geometry = &self.geometry;
        let batch = x.len() / geometry.coarse_len();
        let mut y = vec![0.0; batch * geometry.fine_len()];
        self.for_each_group(&mut y, geometry.fine_len(), |group, y| {
            if DirectConv::fits(geometry) {
                let x = &x[group.coarse(geometry)];
                self.direct(bias, relu, x, y).conv_up();
                return;
            }
            let x = self.channels_first(&x[group.coarse(geometry)], group.samples);
            let mut columns = Columns::zeros(geometry, group.samples);
            let x = Matrix::new(&x, geometry.coarse_channels, columns.count, columns.count);
            matmul(&mut columns.data, columns.stride, self.matrix().transposed(), x);
            columns.col2im(geometry, y);
            for (index, y) in y.chunks_exact_mut(geometry.fine_cells()).enumerate() {
                let bias = bias[index % geometry.fine_channels];
                let least = if relu { 0.0 } else { f32::NEG_INFINITY };
                for y in y {
                    *y = at_least(*y + bias, least);
                }
            }
        });
        y
    }

    /// Returns the layer as a direct convolution of some samples.
    pub(crate) fn direct<'a>(&'a self, bias: &'a [f32], relu: bool, x: &'a [f32], y: &'a mut [f32]) -> DirectConv<'a> {
        DirectConv { geometry: &self.geometry, weight: self.weight, bias, relu, fused: self.fused, x, y }
    }

    /// Returns the weights as a matrix `[coarse_channels, patch_len]`.
    pub(crate) fn matrix(&self) -> Matrix<'_> {
        let patch = self.geometry.patch_len();
        Matrix::new(self.weight, self.geometry.coarse_channels, patch, patch)
    }

    /// Returns coarse images `[samples, coarse_channels, coarse_cells]` as `[coarse_channels, samples * coarse_cells]`.
    pub(crate) fn channels_first(&self, images: &[f32], samples: usize) -> Vec<f32> {
        let cells = self.geometry.coarse_cells();
        let mut transposed = Vec::with_capacity(images.len());
        for channel in 0..self.geometry.coarse_channels {
            for sample in 0..samples {
                transposed
                    .extend_from_slice(&images[(sample * self.geometry.coarse_channels + channel) * cells..][..cells]);
            }
        }
        transposed
    }

    /// Calls `work` for every group of samples with its part of `out`, which has `len` values per sample.
    pub(crate) fn for_each_group(&self, out: &mut [f32], len: usize, work: impl Fn(Group, &mut [f32]) + Sync) {
        let samples = self.group_samples();
        let work = |(index, out): (usize, &mut [f32])| {
            work(Group { first: index * samples, samples: out.len() / len }, out);
        };
        #[cfg(not(target_arch = "wasm32"))]
        if out.len() > samples * len {
            out.par_chunks_mut(samples * len).enumerate().for_each(work);
            return;
        }
        out.chunks_mut(samples * len).enumerate().for_each(work);
    }

    fn group_samples(&self) -> usize {
        if DirectConv::fits(&self.geometry) {
            return DIRECT_GROUP;
        }
        (GROUP_LEN / (self.geometry.patch_len() * self.geometry.coarse_cells())).clamp(1, MAX_GROUP)
    }
}

/// Like `f32::max`, but without its handling of NaN, which is a call in wasm.
fn at_least(value: f32, least: f32) -> f32 {
    if value > least { value } else { least }
}

/// Consecutive samples of a batch.
#[derive(Clone, Copy)]
pub(crate) struct Group {
    pub first: usize,
    pub samples: usize,
}

impl Group {
    /// Returns the range of their fine images in the batch.
    pub(crate) fn fine(&self, geometry: &Geometry) -> std::ops::Range<usize> {
        self.range(geometry.fine_len())
    }

    /// Returns the range of their coarse images in the batch.
    pub(crate) fn coarse(&self, geometry: &Geometry) -> std::ops::Range<usize> {
        self.range(geometry.coarse_len())
    }

    fn range(&self, len: usize) -> std::ops::Range<usize> {
        self.first * len..(self.first + self.samples) * len
    }
}

/// The im2col matrix of a group's fine images, `[patch_len, samples * coarse_cells]`.
pub(crate) struct Columns {
    pub data: Vec<f32>,
    /// Columns: `samples * coarse_cells`.
    pub count: usize,
    /// Distance in values between the starts of two rows.
    pub stride: usize,
    samples: usize,
}

impl Columns {
    pub(crate) fn zeros(geometry: &Geometry, samples: usize) -> Columns {
        let count = samples * geometry.coarse_cells();
        // If row starts were a power of two apart, they would all map to the same cache lines.
        let stride = if count >= 64 { count + 16 } else { count };
        Columns { data: vec![0.0; geometry.patch_len() * stride], count, stride, samples }
    }

    pub(crate) fn im2col(geometry: &Geometry, images: &[f32], samples: usize) -> Columns {
        let mut columns = Columns::zeros(geometry, samples);
        for (sample, image) in images.chunks_exact(geometry.fine_len()).enumerate() {
            geometry.im2col(image, &mut columns.data[sample * geometry.coarse_cells()..], columns.stride);
        }
        columns
    }

    pub(crate) fn col2im(&self, geometry: &Geometry, images: &mut [f32]) {
        for (sample, image) in images.chunks_exact_mut(geometry.fine_len()).enumerate().take(self.samples) {
            geometry.col2im(&self.data[sample * geometry.coarse_cells()..], self.stride, image);
        }
    }

    pub(crate) fn matrix(&self, geometry: &Geometry) -> Matrix<'_> {
        Matrix::new(&self.data, geometry.patch_len(), self.count, self.stride)
    }
}
