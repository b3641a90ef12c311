//! Patches of pictures as columns of a matrix, and back: what turns a strided convolution into a matrix product.
//!
//! A wide picture of side `2 n` is seen by a narrow one of side `n`: each narrow cell sees a `kernel` x `kernel`
//! patch, two cells from patch to patch, centred with zeros around. `gather` writes the patches as columns,
//! `scatter` adds columns back to where they came from. Plain loops over slices; used by the layers alone.

/// How a wide picture and a narrow one meet.
#[derive(Clone, Copy, Debug)]
pub struct Geometry {
    /// Channels of the wide picture.
    pub wide: usize,
    /// Channels of the narrow picture.
    pub narrow: usize,
    /// Cells across the narrow picture; the wide one has twice as many. At most 32.
    pub side: usize,
    /// Cells across a patch, 2 or 4.
    pub kernel: usize,
}

impl Geometry {
    /// Cells of a narrow picture.
    pub fn cells(&self) -> usize {
        self.side * self.side
    }

    /// Cells of a wide picture.
    pub fn wide_cells(&self) -> usize {
        4 * self.cells()
    }

    /// Numbers in a narrow picture of all channels.
    pub fn narrow_picture(&self) -> usize {
        self.narrow * self.cells()
    }

    /// Numbers in a wide picture of all channels.
    pub fn wide_picture(&self) -> usize {
        self.wide * self.wide_cells()
    }

    /// Numbers in a patch of all wide channels.
    pub fn patch(&self) -> usize {
        self.wide * self.taps()
    }

    /// Numbers in a patch of one channel.
    fn taps(&self) -> usize {
        self.kernel * self.kernel
    }

    /// Where a wide row is seen: the row of the kernel and the narrow row, twice at most.
    fn sights(&self, row: usize) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (side, kernel) = (self.side, self.kernel);
        let row = row + (kernel - 2) / 2;
        (row % 2..kernel)
            .step_by(2)
            .filter(move |tap| row >= *tap)
            .map(move |tap| (tap, (row - tap) / 2))
            .filter(move |(_, y)| *y < side)
    }

    /// Writes the patches of one sample as columns: `[wide, 2 side, 2 side]` to `[patch, cells]`, whose rows
    /// begin `stride` numbers apart. `columns` begins at the sample's first column.
    pub fn gather(&self, picture: &[f32], columns: &mut [f32], stride: usize) {
        let (side, kernel) = (self.side, self.kernel);
        for (channel, plane) in picture.chunks_exact(self.wide_cells()).enumerate() {
            let first = channel * self.taps();
            // The outermost rows of the kernel hang over the edge once.
            if kernel == 4 {
                for tap in 0..4 {
                    columns[(first + tap) * stride..][..side].fill(0.0);
                    columns[(first + 12 + tap) * stride + self.cells() - side..][..side].fill(0.0);
                }
            }
            for (row, cells) in plane.chunks_exact(2 * side).enumerate() {
                let halves = split(cells, side);
                for (tap, y) in self.sights(row) {
                    for x_tap in 0..kernel {
                        let at = (first + tap * kernel + x_tap) * stride + y * side;
                        let from = seen(&halves, kernel, x_tap);
                        for (to, from) in columns[at..][..side].iter_mut().zip(from) {
                            *to = *from;
                        }
                    }
                }
            }
        }
    }

    /// Adds up columns where they were gathered from: `[patch, cells]` to `[wide, 2 side, 2 side]`.
    pub fn scatter(&self, columns: &[f32], stride: usize, picture: &mut [f32]) {
        let (side, kernel) = (self.side, self.kernel);
        for (channel, plane) in picture.chunks_exact_mut(self.wide_cells()).enumerate() {
            let first = channel * self.taps();
            for (row, cells) in plane.chunks_exact_mut(2 * side).enumerate() {
                let mut halves: Halves = Default::default();
                for (tap, y) in self.sights(row) {
                    for x_tap in 0..kernel {
                        let at = (first + tap * kernel + x_tap) * stride + y * side;
                        let sums = seen_mut(&mut halves, kernel, x_tap);
                        for (sum, value) in sums.iter_mut().zip(&columns[at..][..side]) {
                            *sum += value;
                        }
                    }
                }
                let (even, odd) = (&halves.0.0[..side], &halves.1.0[1..]);
                for (pair, (even, odd)) in cells.as_chunks_mut::<2>().0.iter_mut().zip(even.iter().zip(odd)) {
                    *pair = [*even, *odd];
                }
            }
        }
    }
}

/// Every other cell of a wide row, with a zero beyond each end: the even ones begin at index 0, the odd at 1.
struct Half([f32; 34]);

type Halves = (Half, Half);

impl Default for Half {
    fn default() -> Half {
        Half([0.0; 34])
    }
}

fn split(row: &[f32], side: usize) -> Halves {
    let mut halves = Halves::default();
    let (even, odd) = (halves.0.0[..side].iter_mut(), halves.1.0[1..].iter_mut());
    for (pair, (even, odd)) in row.as_chunks::<2>().0.iter().zip(even.zip(odd)) {
        (*even, *odd) = (pair[0], pair[1]);
    }
    halves
}

/// What a column of the kernel sees of a row: its cell `2 x + tap - padding` for each x.
fn seen((even, odd): &Halves, kernel: usize, tap: usize) -> &[f32] {
    match (kernel, tap) {
        (4, 0) => &odd.0,
        (4, 1) | (2, 0) => &even.0,
        (4, 2) | (2, 1) => &odd.0[1..],
        _ => &even.0[1..],
    }
}

fn seen_mut((even, odd): &mut Halves, kernel: usize, tap: usize) -> &mut [f32] {
    match (kernel, tap) {
        (4, 0) => &mut odd.0,
        (4, 1) | (2, 0) => &mut even.0,
        (4, 2) | (2, 1) => &mut odd.0[1..],
        _ => &mut even.0[1..],
    }
}
