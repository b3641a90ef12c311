//! One layer on plain slices: what it makes of a batch of pictures.
//!
//! The batch goes in groups of samples, small enough for their patches to stay in the cache. Pictures are
//! `[batch, channels, side, side]`; within a group they become matrices `[channels, group x cells]`.

#[cfg(not(target_arch = "wasm32"))]
use rayon::prelude::*;

use super::im2col::Geometry;
use super::matmul::{Matrix, product};

/// Numbers in the patches of a group: what the second level of a cache holds.
const GROUP: usize = 1 << 16;

/// Samples in a group at most, so that a batch of 32 keeps two cores busy.
const LARGEST: usize = 16;

/// A layer with its weights, `[narrow, wide, kernel, kernel]`: a matrix of a row for each narrow channel.
#[derive(Clone, Copy)]
pub struct Layer<'a> {
    pub geometry: Geometry,
    pub weight: &'a [f32],
}

impl Layer<'_> {
    /// Convolution, bias and relu. `[batch, wide, 2 side, 2 side]` to `[batch, narrow, side, side]`.
    pub fn halve(&self, x: &[f32], bias: &[f32]) -> Vec<f32> {
        let Geometry { narrow, .. } = self.geometry;
        let cells = self.geometry.cells();
        let batch = x.len() / self.geometry.wide_picture();
        let mut y = vec![0.0; batch * self.geometry.narrow_picture()];
        self.each_group(&mut y, self.geometry.narrow_picture(), |group, y| {
            let columns = Columns::gathered(&self.geometry, &x[group.wide(&self.geometry)], group.samples);
            let mut sums = vec![0.0; narrow * columns.count];
            product(&mut sums, columns.count, self.matrix(), columns.matrix(&self.geometry));
            for (index, y) in y.chunks_exact_mut(cells).enumerate() {
                let (sample, channel) = (index / narrow, index % narrow);
                let sums = &sums[channel * columns.count + sample * cells..][..cells];
                for (y, sum) in y.iter_mut().zip(sums) {
                    *y = (sum + bias[channel]).max(0.0);
                }
            }
        });
        y
    }

    /// Transposed convolution, bias, and relu if `positive`. `[batch, narrow, side, side]` to
    /// `[batch, wide, 2 side, 2 side]`.
    pub fn double(&self, x: &[f32], bias: &[f32], positive: bool) -> Vec<f32> {
        let batch = x.len() / self.geometry.narrow_picture();
        let mut y = vec![0.0; batch * self.geometry.wide_picture()];
        self.each_group(&mut y, self.geometry.wide_picture(), |group, y| {
            let x = self.channels_first(&x[group.narrow(&self.geometry)], group.samples);
            let mut columns = Columns::new(&self.geometry, group.samples);
            let x = Matrix::new(&x, self.geometry.narrow, columns.count, columns.count);
            product(&mut columns.data, columns.stride, self.matrix().transposed(), x);
            columns.scatter(&self.geometry, y);
            for (index, y) in y.chunks_exact_mut(self.geometry.wide_cells()).enumerate() {
                let (bias, least) = (bias[index % self.geometry.wide], if positive { 0.0 } else { f32::NEG_INFINITY });
                for y in y {
                    *y = (*y + bias).max(least);
                }
            }
        });
        y
    }

    /// The weights, `[narrow, patch]`.
    pub fn matrix(&self) -> Matrix<'_> {
        let patch = self.geometry.patch();
        Matrix::new(self.weight, self.geometry.narrow, patch, patch)
    }

    /// Narrow pictures `[samples, narrow, cells]` as `[narrow, samples x cells]`.
    pub fn channels_first(&self, pictures: &[f32], samples: usize) -> Vec<f32> {
        let cells = self.geometry.cells();
        let mut turned = Vec::with_capacity(pictures.len());
        for channel in 0..self.geometry.narrow {
            for sample in 0..samples {
                turned.extend_from_slice(&pictures[(sample * self.geometry.narrow + channel) * cells..][..cells]);
            }
        }
        turned
    }

    /// Calls `work` for every group of samples with its part of `out`, of `size` numbers a sample.
    pub fn each_group(&self, out: &mut [f32], size: usize, work: impl Fn(Group, &mut [f32]) + Sync) {
        let samples = self.group();
        let work = |(index, out): (usize, &mut [f32])| {
            work(Group { first: index * samples, samples: out.len() / size }, out);
        };
        #[cfg(not(target_arch = "wasm32"))]
        if out.len() > samples * size {
            out.par_chunks_mut(samples * size).enumerate().for_each(work);
            return;
        }
        out.chunks_mut(samples * size).enumerate().for_each(work);
    }

    /// Samples in a group.
    fn group(&self) -> usize {
        (GROUP / (self.geometry.patch() * self.geometry.cells())).clamp(1, LARGEST)
    }
}

/// Some samples of a batch, one after another.
#[derive(Clone, Copy)]
pub struct Group {
    pub first: usize,
    pub samples: usize,
}

impl Group {
    /// Where their wide pictures lie.
    pub fn wide(&self, geometry: &Geometry) -> std::ops::Range<usize> {
        self.range(geometry.wide_picture())
    }

    /// Where their narrow pictures lie.
    pub fn narrow(&self, geometry: &Geometry) -> std::ops::Range<usize> {
        self.range(geometry.narrow_picture())
    }

    fn range(&self, size: usize) -> std::ops::Range<usize> {
        self.first * size..(self.first + self.samples) * size
    }
}

/// The patches of a group's wide pictures, `[patch, samples x cells]`.
pub struct Columns {
    pub data: Vec<f32>,
    pub count: usize,
    pub stride: usize,
    samples: usize,
}

impl Columns {
    pub fn new(geometry: &Geometry, samples: usize) -> Columns {
        let count = samples * geometry.cells();
        // Rows a power of two apart would all fall on the same lines of the cache.
        let stride = if count >= 64 { count + 16 } else { count };
        Columns { data: vec![0.0; geometry.patch() * stride], count, stride, samples }
    }

    pub fn gathered(geometry: &Geometry, pictures: &[f32], samples: usize) -> Columns {
        let mut columns = Columns::new(geometry, samples);
        for (sample, picture) in pictures.chunks_exact(geometry.wide_picture()).enumerate() {
            geometry.gather(picture, &mut columns.data[sample * geometry.cells()..], columns.stride);
        }
        columns
    }

    pub fn scatter(&self, geometry: &Geometry, pictures: &mut [f32]) {
        for (sample, picture) in pictures.chunks_exact_mut(geometry.wide_picture()).enumerate().take(self.samples) {
            geometry.scatter(&self.data[sample * geometry.cells()..], self.stride, picture);
        }
    }

    pub fn matrix(&self, geometry: &Geometry) -> Matrix<'_> {
        Matrix::new(&self.data, geometry.patch(), self.count, self.stride)
    }
}
