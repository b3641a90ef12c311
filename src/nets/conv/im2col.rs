//! im2col and col2im: patches of an image as the columns of a matrix, and columns added back into an image.
//!
//! A fine image of side `2 n` corresponds to a coarse one of side `n`: each coarse cell covers a `kernel` x `kernel`
//! patch of the fine image, with stride 2 and zero padding `(kernel - 2) / 2`. `im2col` copies the patches into
//! columns; `col2im`, its adjoint, adds the columns back to where they came from. Plain loops over slices; used only by
//! `forward` and `backward`.

/// The geometry of a fine image and a coarse one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Geometry {
    /// Channels of the fine image.
    pub fine_channels: usize,
    /// Channels of the coarse image.
    pub coarse_channels: usize,
    /// Cells across the coarse image, at most 32; the fine one has twice as many.
    pub coarse_side: usize,
    /// Cells across a patch, 2 or 4.
    pub kernel: usize,
}

impl Geometry {
    /// Returns the number of cells in one channel of a coarse image.
    pub(crate) fn coarse_cells(&self) -> usize {
        self.coarse_side * self.coarse_side
    }

    /// Returns the number of cells in one channel of a fine image.
    pub(crate) fn fine_cells(&self) -> usize {
        4 * self.coarse_cells()
    }

    /// Returns the number of values of a coarse image in all channels.
    pub(crate) fn coarse_len(&self) -> usize {
        self.coarse_channels * self.coarse_cells()
    }

    /// Returns the number of values of a fine image in all channels.
    pub(crate) fn fine_len(&self) -> usize {
        self.fine_channels * self.fine_cells()
    }

    /// Returns the number of values of a patch in all fine channels.
    pub(crate) fn patch_len(&self) -> usize {
        self.fine_channels * self.taps()
    }

    /// Returns the number of taps of the kernel of one channel.
    fn taps(&self) -> usize {
        self.kernel * self.kernel
    }

    /// Returns the taps that cover a fine row: at most two pairs of a kernel row and the coarse row whose patch it
    /// belongs to.
    fn row_taps(&self, fine_row: usize) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (side, kernel) = (self.coarse_side, self.kernel);
        let padded_row = fine_row + (kernel - 2) / 2;
        (padded_row % 2..kernel)
            .step_by(2)
            .filter(move |tap| padded_row >= *tap)
            .map(move |tap| (tap, (padded_row - tap) / 2))
            .filter(move |(_, coarse_row)| *coarse_row < side)
    }

    /// Copies the patches of one sample into columns: `[fine_channels, 2 n, 2 n]` to `[patch_len, coarse_cells]`, whose
    /// rows begin `stride` values apart. `columns` begins at the sample's first column and holds zeros.
    pub(crate) fn im2col(&self, image: &[f32], columns: &mut [f32], stride: usize) {
        // With a side that the compiler knows, rows of one to four cells are not copied by calls.
        match self.coarse_side {
            1 => self.im2col_of_side(1, image, columns, stride),
            2 => self.im2col_of_side(2, image, columns, stride),
            4 => self.im2col_of_side(4, image, columns, stride),
            side => self.im2col_of_side(side, image, columns, stride),
        }
    }

    #[inline(always)]
    fn im2col_of_side(&self, side: usize, image: &[f32], columns: &mut [f32], stride: usize) {
        let kernel = self.kernel;
        for (channel, plane) in image.chunks_exact(self.fine_cells()).enumerate() {
            let first = channel * self.taps();
            for (fine_row, cells) in plane.chunks_exact(2 * side).enumerate() {
                let row = deinterleave(cells, side);
                for (tap, coarse_row) in self.row_taps(fine_row) {
                    for column_tap in 0..kernel {
                        let at = (first + tap * kernel + column_tap) * stride + coarse_row * side;
                        let source = covered(&row, kernel, column_tap);
                        for (to, from) in columns[at..][..side].iter_mut().zip(source) {
                            *to = *from;
                        }
                    }
                }
            }
        }
    }

    /// Adds columns back to where `im2col` took them from: `[patch_len, coarse_cells]` to `[fine_channels, 2 n, 2 n]`.
    pub(crate) fn col2im(&self, columns: &[f32], stride: usize, image: &mut [f32]) {
        match self.coarse_side {
            1 => self.col2im_of_side(1, columns, stride, image),
            2 => self.col2im_of_side(2, columns, stride, image),
            4 => self.col2im_of_side(4, columns, stride, image),
            side => self.col2im_of_side(side, columns, stride, image),
        }
    }

    #[inline(always)]
    fn col2im_of_side(&self, side: usize, columns: &[f32], stride: usize, image: &mut [f32]) {
        let kernel = self.kernel;
        for (channel, plane) in image.chunks_exact_mut(self.fine_cells()).enumerate() {
            let first = channel * self.taps();
            for (fine_row, cells) in plane.chunks_exact_mut(2 * side).enumerate() {
                let mut row = DeinterleavedRow::default();
                for (tap, coarse_row) in self.row_taps(fine_row) {
                    for column_tap in 0..kernel {
                        let at = (first + tap * kernel + column_tap) * stride + coarse_row * side;
                        let sums = covered_mut(&mut row, kernel, column_tap);
                        for (sum, value) in sums.iter_mut().zip(&columns[at..][..side]) {
                            *sum += value;
                        }
                    }
                }
                let (even, odd) = (&row.even[..side], &row.odd[1..]);
                for (pair, (even, odd)) in cells.as_chunks_mut::<2>().0.iter_mut().zip(even.iter().zip(odd)) {
                    *pair = [*even, *odd];
                }
            }
        }
    }
}

/// The even and the odd cells of a fine row, so that the cells covered by a column of the kernel are contiguous. Cell 0
/// is `even[0]` and cell 1 is `odd[1]`; the entries beyond both ends are padding.
struct DeinterleavedRow {
    even: [f32; 34],
    odd: [f32; 34],
}

impl Default for DeinterleavedRow {
    fn default() -> DeinterleavedRow {
        DeinterleavedRow { even: [0.0; 34], odd: [0.0; 34] }
    }
}

fn deinterleave(cells: &[f32], side: usize) -> DeinterleavedRow {
    let mut row = DeinterleavedRow::default();
    let (even, odd) = (row.even[..side].iter_mut(), row.odd[1..].iter_mut());
    for (pair, (even, odd)) in cells.as_chunks::<2>().0.iter().zip(even.zip(odd)) {
        (*even, *odd) = (pair[0], pair[1]);
    }
    row
}

/// Returns the cells of a fine row that a column of the kernel covers: the cell `2 x + tap - padding` for each coarse
/// column x.
fn covered(row: &DeinterleavedRow, kernel: usize, tap: usize) -> &[f32] {
    match (kernel, tap) {
        (4, 0) => &row.odd,
        (4, 1) | (2, 0) => &row.even,
        (4, 2) | (2, 1) => &row.odd[1..],
        _ => &row.even[1..],
    }
}

fn covered_mut(row: &mut DeinterleavedRow, kernel: usize, tap: usize) -> &mut [f32] {
    match (kernel, tap) {
        (4, 0) => &mut row.odd,
        (4, 1) | (2, 0) => &mut row.even,
        (4, 2) | (2, 1) => &mut row.odd[1..],
        _ => &mut row.even[1..],
    }
}
