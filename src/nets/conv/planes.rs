//! Images within a border of zeros, the input format of the direct convolutions. Used by `direct` and
//! `weight_gradient`.

/// The channels of an image within a border of zeros.
pub(crate) struct Planes {
    pub data: Vec<f32>,
    /// Values in a channel.
    pub len: usize,
    /// Values in a row.
    pub row: usize,
}

impl Planes {
    /// Allocates planes for coarse images of this side.
    pub(crate) fn new(channels: usize, side: usize) -> Planes {
        let row = side + 2;
        Planes { data: vec![0.0; channels * row * row], len: row * row, row }
    }

    /// Allocates planes for fine images of side `2 side`, split into phases.
    pub(crate) fn with_phases(channels: usize, side: usize) -> Planes {
        let (rows, row) = (2 * side + 2, 2 * (side + 1));
        Planes { data: vec![0.0; channels * rows * row], len: rows * row, row }
    }

    /// Returns the offsets of the pairs of neighbouring taps of a 4 x 4 kernel: for each of its rows, columns 0 and 2
    /// in the even phase, and columns 1 and 3 in the odd phase.
    #[inline(always)]
    pub(crate) fn pairs_of_taps(&self) -> [usize; 8] {
        std::array::from_fn(|pair| pair / 2 * self.row + pair % 2 * (self.row / 2))
    }

    /// Copies an image of this side inside the border.
    #[inline(always)]
    pub(crate) fn fill(&mut self, image: &[f32], side: usize) {
        for (plane, cells) in self.data.chunks_exact_mut(self.len).zip(image.chunks_exact(side * side)) {
            for (row, cells) in plane[self.row..].chunks_exact_mut(self.row).zip(cells.chunks_exact(side)) {
                // In wasm, a copy whose length the compiler does not know is a call. A side is a multiple of 8.
                let to = row[1..=side].as_chunks_mut::<8>().0;
                to.iter_mut().zip(cells.as_chunks().0).for_each(|(to, from)| *to = *from);
            }
        }
    }

    /// Copies a fine image of side `2 side` inside the border. In each row, the even padded columns come before the odd
    /// ones, `side + 1` each.
    #[inline(always)]
    pub(crate) fn fill_with_phases(&mut self, image: &[f32], side: usize) {
        for (plane, cells) in self.data.chunks_exact_mut(self.len).zip(image.chunks_exact(4 * side * side)) {
            for (row, cells) in plane[self.row..].chunks_exact_mut(self.row).zip(cells.chunks_exact(2 * side)) {
                // The border moves every column by one, so the odd columns of the image are even ones here.
                let (even, odd) = row.split_at_mut(side + 1);
                for ((pair, even), odd) in cells.as_chunks::<2>().0.iter().zip(&mut even[1..]).zip(odd) {
                    (*odd, *even) = (pair[0], pair[1]);
                }
            }
        }
    }
}
