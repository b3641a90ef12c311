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
    /// Copies a coarse image of this side.
    #[inline(always)]
    pub(crate) fn new(image: &[f32], channels: usize, side: usize) -> Planes {
        let row = side + 2;
        let mut planes = Planes { data: vec![0.0; channels * row * row], len: row * row, row };
        for (plane, cells) in planes.data.chunks_exact_mut(planes.len).zip(image.chunks_exact(side * side)) {
            for (row, cells) in plane[row..].chunks_exact_mut(row).zip(cells.chunks_exact(side)) {
                // In wasm, a copy whose length the compiler does not know is a call. A side is a multiple of 8.
                let to = row[1..=side].as_chunks_mut::<8>().0;
                to.iter_mut().zip(cells.as_chunks().0).for_each(|(to, from)| *to = *from);
            }
        }
        planes
    }

    /// Copies a fine image of side `2 side` split into phases: in each row, the even padded columns come before the odd
    /// ones, `side + 1` each.
    #[inline(always)]
    pub(crate) fn with_phases(image: &[f32], channels: usize, side: usize) -> Planes {
        let (rows, row) = (2 * side + 2, 2 * (side + 1));
        let mut planes = Planes { data: vec![0.0; channels * rows * row], len: rows * row, row };
        for (plane, cells) in planes.data.chunks_exact_mut(planes.len).zip(image.chunks_exact(4 * side * side)) {
            for (row, cells) in plane[row..].chunks_exact_mut(row).zip(cells.chunks_exact(2 * side)) {
                // The border moves every column by one, so the odd columns of the image are even ones here.
                let (even, odd) = row.split_at_mut(side + 1);
                for ((pair, even), odd) in cells.as_chunks::<2>().0.iter().zip(&mut even[1..]).zip(odd) {
                    (*odd, *even) = (pair[0], pair[1]);
                }
            }
        }
        planes
    }

    /// Returns the offsets of the pairs of neighbouring taps of a 4 x 4 kernel: for each of its rows, columns 0 and 2
    /// in the even phase, and columns 1 and 3 in the odd phase.
    #[inline(always)]
    pub(crate) fn pairs_of_taps(&self) -> [usize; 8] {
        std::array::from_fn(|pair| pair / 2 * self.row + pair % 2 * (self.row / 2))
    }
}
