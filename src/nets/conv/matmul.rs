//! The matrix product under both layers: the gemm crate natively, our own loops in wasm.
//!
//! gemm packs both matrices into tiles first, which pays off for batches. For the single scene that a browser
//! evaluates, each weight is read only once, and packing costs more than the sums: `wasm_matmul` reads the
//! weights where they lie. Used by `forward` and `backward` only.

/// Rows of `a` that `wasm_matmul` takes at once: their number must be a multiple of this, unless `b` is one column.
pub const TILE_ROWS: usize = 8;

/// A matrix in a slice. Element (row, column) is `data[row * row_stride + column * column_stride]`, and every element
/// lies within the slice: only the constructor sets the fields, and the unsafe call below relies on it.
#[derive(Clone, Copy)]
pub struct Matrix<'a> {
    data: &'a [f32],
    rows: usize,
    columns: usize,
    row_stride: usize,
    column_stride: usize,
}

impl<'a> Matrix<'a> {
    /// Returns a row-major matrix whose rows begin `stride` values apart. Panics if it does not fit the slice.
    pub fn new(data: &'a [f32], rows: usize, columns: usize, stride: usize) -> Matrix<'a> {
        let matrix = Matrix { data, rows, columns, row_stride: stride, column_stride: 1 };
        assert!(rows > 0 && columns > 0 && (rows - 1) * stride + columns <= data.len(), "the matrix fits its slice");
        matrix
    }

    /// Returns the transpose, without copying.
    pub fn transposed(self) -> Matrix<'a> {
        let Matrix { data, rows, columns, row_stride, column_stride } = self;
        Matrix { data, rows: columns, columns: rows, row_stride: column_stride, column_stride: row_stride }
    }
}

/// `out = a b`; the rows of `out` begin `stride` values apart.
pub fn matmul(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    assert!(a.columns == b.rows && (a.rows - 1) * stride + b.columns <= out.len(), "the product fits its slice");
    #[cfg(target_arch = "wasm32")]
    {
        wasm_matmul::matmul(out, stride, a, b);
    }
    #[cfg(not(target_arch = "wasm32"))]
    // SAFETY: every element of `a` and `b` lies within its slice (`Matrix::new`), and by the assertion above so does
    // every element of the product in `out`.
    unsafe {
        gemm::gemm(
            a.rows,
            b.columns,
            a.columns,
            out.as_mut_ptr(),
            1,
            stride as isize,
            false,
            a.data.as_ptr(),
            a.column_stride as isize,
            a.row_stride as isize,
            b.data.as_ptr(),
            b.column_stride as isize,
            b.row_stride as isize,
            1.0,
            1.0,
            false,
            false,
            false,
            gemm::Parallelism::None,
        );
    }
}

/// A product that reads its matrices where they lie, in tiles that stay in wasm's vector registers.
#[cfg(any(target_arch = "wasm32", test))]
mod wasm_matmul {
    use super::{Matrix, TILE_ROWS};

    /// The values of a 128-bit register.
    type Vector = [f32; 4];

    /// `out = a b` for a `b` of contiguous rows: one column, or a multiple of four.
    pub fn matmul(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
        assert!(b.column_stride == 1, "rows of b are contiguous");
        match b.columns {
            1 => matvec(out, stride, a, b),
            4 => tiles::<TILE_ROWS, 1>(out, stride, a, b),
            _ => tiles::<{ TILE_ROWS / 2 }, 2>(out, stride, a, b),
        }
    }

    /// Tiles of `ROWS` rows by `4 * VECTORS` columns, accumulated in registers.
    fn tiles<const ROWS: usize, const VECTORS: usize>(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
        assert!(a.rows.is_multiple_of(ROWS) && b.columns.is_multiple_of(4 * VECTORS), "whole tiles");
        for row in (0..a.rows).step_by(ROWS) {
            for column in (0..b.columns).step_by(4 * VECTORS) {
                let mut sums = [[[0.0; 4]; VECTORS]; ROWS];
                for k in 0..a.columns {
                    let right: [Vector; VECTORS] = std::array::from_fn(|vector| {
                        let at = k * b.row_stride + column + 4 * vector;
                        b.data[at..at + 4].try_into().expect("four values")
                    });
                    for (i, sums) in sums.iter_mut().enumerate() {
                        let left = a.data[(row + i) * a.row_stride + k * a.column_stride];
                        for (sum, right) in sums.iter_mut().zip(right) {
                            for (sum, right) in sum.iter_mut().zip(right) {
                                *sum += left * right;
                            }
                        }
                    }
                }
                for (i, sums) in sums.iter().enumerate() {
                    let at = (row + i) * stride + column;
                    out[at..at + 4 * VECTORS].copy_from_slice(sums.as_flattened());
                }
            }
        }
    }

    /// A matrix times one column.
    fn matvec(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
        if a.column_stride == 1 {
            let right: Vec<f32> = (0..b.rows).map(|k| b.data[k * b.row_stride]).collect();
            for row in 0..a.rows {
                let left = &a.data[row * a.row_stride..][..a.columns];
                out[row * stride] = dot(left, &right);
            }
        } else {
            let mut sums = vec![0.0; a.rows];
            for k in 0..a.columns {
                let right = b.data[k * b.row_stride];
                let left = &a.data[k * a.column_stride..][..a.rows];
                for (sum, left) in sums.iter_mut().zip(left) {
                    *sum += left * right;
                }
            }
            for (row, sum) in sums.into_iter().enumerate() {
                out[row * stride] = sum;
            }
        }
    }

    /// Sixteen partial sums, so that no addition waits for the previous one.
    fn dot(left: &[f32], right: &[f32]) -> f32 {
        let mut sums = [0.0; 16];
        let ((left, left_rest), (right, right_rest)) = (left.as_chunks::<16>(), right.as_chunks::<16>());
        for (left, right) in left.iter().zip(right) {
            for (sum, (left, right)) in sums.iter_mut().zip(left.iter().zip(right)) {
                *sum += left * right;
            }
        }
        let rest: f32 = left_rest.iter().zip(right_rest).map(|(left, right)| left * right).sum();
        sums.iter().sum::<f32>() + rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The shapes of one scene: tiles, four columns, one column; weights as they are and transposed.
    #[test]
    fn the_loops_of_wasm_agree_with_gemm() {
        let values = |count: usize| -> Vec<f32> { (0..count).map(|i| ((i * 37 % 101) as f32 - 50.0) / 50.0).collect() };
        for (rows, depth, columns) in [(8, 80, 1024), (64, 512, 16), (128, 1024, 4), (256, 512, 1)] {
            let (a, b) = (values(rows * depth), values(depth * (columns + 16)));
            let b = Matrix::new(&b, depth, columns, columns + 16);
            for a in [Matrix::new(&a, rows, depth, depth), Matrix::new(&a, depth, rows, rows).transposed()] {
                let (mut ours, mut gemm) = (vec![0.0; rows * columns], vec![0.0; rows * columns]);
                wasm_matmul::matmul(&mut ours, columns, a, b);
                matmul(&mut gemm, columns, a, b);
                let worst = ours.iter().zip(&gemm).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(worst < 1e-3 && gemm.iter().any(|x| x.abs() > 1.0), "{rows} x {depth} x {columns}: {worst}");
            }
        }
    }
}
