//! The matrix product of the layers with few cells: our own loops for one scene, the gemm crate for batches.
//!
//! gemm first packs both matrices into tiles. This pays off for batches, where its products also include those of the
//! weight gradients. For one scene, each weight is read only once or a few times, and packing costs more than the sums:
//! `few_columns` reads the weights in place. Used by `forward` and `backward`.

use pulp::{Simd, WithSimd, bytemuck};

use super::simd::{lanes_that_divide, load, multiply_add, vectorize};

/// Rows of `a` that `few_columns` processes at once. The number of rows must be a multiple of this, unless `b` is one
/// column.
pub(crate) const TILE_ROWS: usize = 8;

/// Maximum number of lanes in the registers that hold rows.
const ROWS_LANES: usize = 16;

/// Maximum number of columns of `b` for which gemm does not pay off.
#[cfg(not(target_arch = "wasm32"))]
const FEW_COLUMNS: usize = 32;

/// A matrix in a slice. Element (row, column) is `data[row * row_stride + column * column_stride]`, and every element
/// lies within the slice: only the constructor sets the fields, and the unsafe call below relies on it.
#[derive(Clone, Copy)]
pub(crate) struct Matrix<'a> {
    data: &'a [f32],
    rows: usize,
    columns: usize,
    row_stride: usize,
    column_stride: usize,
}

impl<'a> Matrix<'a> {
    /// Returns a row-major matrix whose rows begin `stride` values apart. Panics if it does not fit the slice.
    pub(crate) fn new(data: &'a [f32], rows: usize, columns: usize, stride: usize) -> Matrix<'a> {
        let matrix = Matrix { data, rows, columns, row_stride: stride, column_stride: 1 };
        assert!(rows > 0 && columns > 0 && (rows - 1) * stride + columns <= data.len(), "the matrix fits its slice");
        matrix
    }

    /// Returns the transpose, without copying.
    pub(crate) fn transposed(self) -> Matrix<'a> {
        let Matrix { data, rows, columns, row_stride, column_stride } = self;
        Matrix { data, rows: columns, columns: rows, row_stride: column_stride, column_stride: row_stride }
    }
}

/// Computes `out = a b`; the rows of `out` begin `stride` values apart.
pub(crate) fn matmul(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    assert!(a.columns == b.rows && (a.rows - 1) * stride + b.columns <= out.len(), "the product fits its slice");
    #[cfg(not(target_arch = "wasm32"))]
    if b.column_stride != 1 || b.columns > FEW_COLUMNS || !(b.columns == 1 || b.columns.is_multiple_of(4)) {
        gemm(out, stride, a, b);
        return;
    }
    few_columns(out, stride, a, b);
}

#[cfg(not(target_arch = "wasm32"))]
fn gemm(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    assert!(a.columns == b.rows && (a.rows - 1) * stride + b.columns <= out.len(), "the product fits its slice");
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

/// Computes `out = a b` for a `b` with contiguous rows: one column, or a multiple of four.
fn few_columns(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    assert!(b.column_stride == 1, "rows of b are contiguous");
    let has_rows = b.columns == 1 || fits_rows(a, b);
    let lanes = if has_rows { ROWS_LANES } else { lanes_that_divide(b.columns).min(8) };
    vectorize(lanes, FewColumns { out, stride, a, b });
}

/// Returns whether `rows_in_registers` can multiply them.
fn fits_rows(a: Matrix, b: Matrix) -> bool {
    b.columns == 4 && a.row_stride == 1 && a.rows.is_multiple_of(2 * ROWS_LANES)
}

struct FewColumns<'a> {
    out: &'a mut [f32],
    stride: usize,
    a: Matrix<'a>,
    b: Matrix<'a>,
}

impl WithSimd for FewColumns<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let FewColumns { out, stride, a, b } = self;
        if b.columns == 1 {
            matvec(out, stride, a, b);
        } else if fits_rows(a, b) {
            rows_in_registers::<S>(simd, out, stride, a, b);
        } else if b.columns == S::F32_LANES && a.column_stride != 1 {
            one_register::<S>(simd, out, stride, a, b);
        } else if b.columns.is_multiple_of(2 * S::F32_LANES) {
            tiles::<S, { TILE_ROWS / 2 }, 2>(simd, out, stride, a, b);
        } else {
            tiles::<S, TILE_ROWS, 1>(simd, out, stride, a, b);
        }
    }
}

/// Multiplies in tiles of `ROWS` rows by `REGISTERS` registers of columns.
#[expect(clippy::needless_range_loop, reason = "iterators make the code for wasm slower")]
#[inline(always)]
fn tiles<S: Simd, const ROWS: usize, const REGISTERS: usize>(
    simd: S,
    out: &mut [f32],
    stride: usize,
    a: Matrix,
    b: Matrix,
) {
    let width = REGISTERS * S::F32_LANES;
    assert!(a.rows.is_multiple_of(ROWS) && b.columns.is_multiple_of(width), "whole tiles");
    for row in (0..a.rows).step_by(ROWS) {
        for column in (0..b.columns).step_by(width) {
            let mut sums = [[simd.splat_f32s(0.0); REGISTERS]; ROWS];
            let right = |k: usize| -> [S::f32s; REGISTERS] {
                let right = &b.data[k * b.row_stride + column..][..width];
                std::array::from_fn(|register| load::<S>(right, register * S::F32_LANES))
            };
            if a.column_stride == 1 {
                let rows: [&[f32]; ROWS] =
                    std::array::from_fn(|index| &a.data[(row + index) * a.row_stride..][..a.columns]);
                for k in 0..a.columns {
                    let right = right(k);
                    for index in 0..ROWS {
                        multiply_add(simd, &mut sums[index], rows[index][k], right);
                    }
                }
            } else {
                for k in 0..a.columns {
                    let right = right(k);
                    let left = &a.data[k * a.column_stride + row..][..ROWS];
                    for index in 0..ROWS {
                        multiply_add(simd, &mut sums[index], left[index], right);
                    }
                }
            }
            for (index, sums) in sums.iter().enumerate() {
                let out = &mut out[(row + index) * stride + column..][..width];
                S::as_mut_simd_f32s(out).0.copy_from_slice(sums);
            }
        }
    }
}

/// Multiplies a transposed matrix by four columns. A register holds the sums of neighbouring rows in one column.
#[inline(always)]
fn rows_in_registers<S: Simd>(simd: S, out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    let height = 2 * S::F32_LANES;
    for row in (0..a.rows).step_by(height) {
        let mut sums = [[simd.splat_f32s(0.0); 2]; 4];
        for k in 0..a.columns {
            let left = &a.data[k * a.column_stride + row..][..height];
            let left = [load::<S>(left, 0), load::<S>(left, S::F32_LANES)];
            let right = &b.data[k * b.row_stride..][..4];
            for (sums, right) in sums.iter_mut().zip(right) {
                multiply_add(simd, sums, *right, left);
            }
        }
        let sums: [&[f32]; 4] = sums.each_ref().map(|sums| bytemuck::cast_slice(sums));
        for (index, out) in out[row * stride..].chunks_mut(stride).take(height).enumerate() {
            for (out, sums) in out.iter_mut().zip(sums) {
                *out = sums[index];
            }
        }
    }
}

/// Multiplies a transposed matrix by one register of columns, four rows of the untransposed matrix at a time, so that
/// memory is read in order.
#[inline(always)]
fn one_register<S: Simd>(simd: S, out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    assert!(a.columns.is_multiple_of(4) && a.row_stride == 1, "whole tiles");
    for k in (0..a.columns).step_by(4) {
        let left: [&[f32]; 4] = std::array::from_fn(|index| &a.data[(k + index) * a.column_stride..][..a.rows]);
        let right: [S::f32s; 4] = std::array::from_fn(|index| load::<S>(b.data, (k + index) * b.row_stride));
        for (row, out) in out.chunks_mut(stride).take(a.rows).enumerate() {
            let out = &mut S::as_mut_simd_f32s(&mut out[..S::F32_LANES]).0[0];
            let mut sum = [if k == 0 { simd.splat_f32s(0.0) } else { *out }];
            for (left, right) in left.iter().zip(right) {
                multiply_add(simd, &mut sum, left[row], [right]);
            }
            *out = sum[0];
        }
    }
}

/// Multiplies a matrix by one column.
#[inline(always)]
fn matvec(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    let right: Vec<f32> = (0..b.rows).map(|k| b.data[k * b.row_stride]).collect();
    if a.column_stride == 1 {
        for row in 0..a.rows {
            let left = &a.data[row * a.row_stride..][..a.columns];
            out[row * stride] = dot(left, &right);
        }
        return;
    }
    let mut sums = vec![0.0; a.rows];
    let (fours, rest) = right.as_chunks::<4>();
    for (index, right) in fours.iter().enumerate() {
        let column = |k: usize| &a.data[(4 * index + k) * a.column_stride..][..a.rows];
        let columns = column(0).iter().zip(column(1)).zip(column(2)).zip(column(3));
        for (sum, (((first, second), third), fourth)) in sums.iter_mut().zip(columns) {
            *sum += first * right[0];
            *sum += second * right[1];
            *sum += third * right[2];
            *sum += fourth * right[3];
        }
    }
    for (k, right) in rest.iter().enumerate() {
        let left = &a.data[(4 * fours.len() + k) * a.column_stride..][..a.rows];
        for (sum, left) in sums.iter_mut().zip(left) {
            *sum += left * right;
        }
    }
    for (row, sum) in sums.into_iter().enumerate() {
        out[row * stride] = sum;
    }
}

/// Uses sixteen partial sums, so that no addition waits for the previous one.
#[inline(always)]
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

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;

    /// The shapes that occur for one scene: tiles, four columns, one column; weights as stored and transposed.
    #[test]
    fn the_loops_for_few_columns_agree_with_gemm() {
        let values = |count: usize| -> Vec<f32> { (0..count).map(|i| ((i * 37 % 101) as f32 - 50.0) / 50.0).collect() };
        for (rows, depth, columns) in [(8, 80, 1024), (64, 512, 16), (128, 1024, 4), (256, 512, 1)] {
            let (a, b) = (values(rows * depth), values(depth * (columns + 16)));
            let b = Matrix::new(&b, depth, columns, columns + 16);
            for a in [Matrix::new(&a, rows, depth, depth), Matrix::new(&a, depth, rows, rows).transposed()] {
                let mut ours = vec![0.0; rows * columns];
                let mut gemm = ours.clone();
                few_columns(&mut ours, columns, a, b);
                super::gemm(&mut gemm, columns, a, b);
                let worst = ours.iter().zip(&gemm).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(worst < 1e-3 && gemm.iter().any(|x| x.abs() > 1.0), "{rows} x {depth} x {columns}: {worst}");
            }
        }
    }

    /// The unsafe call relies on this.
    #[test]
    fn matrices_that_do_not_fit_their_slices_are_refused() {
        let data = vec![0.0; 40 * 40];
        let is_refused = |run: &dyn Fn()| std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).is_err();
        for (rows, columns, stride) in [(41, 40, 40), (40, 41, 40), (2, 1, 1600), (0, 1, 1), (1, 0, 1)] {
            assert!(is_refused(&|| _ = Matrix::new(&data, rows, columns, stride)), "{rows} x {columns}, {stride}");
        }
        let (a, b) = (Matrix::new(&data, 40, 40, 40), Matrix::new(&data, 40, 36, 40));
        for (length, stride) in [(39 * 36 + 35, 36), (39 * 40 + 35, 40), (0, 0)] {
            assert!(is_refused(&|| matmul(&mut vec![0.0; length], stride, a, b)), "{length}, {stride}");
        }
        assert!(is_refused(&|| matmul(&mut vec![0.0; 1600], 36, b, a)), "36 columns by 40 rows");
        matmul(&mut vec![0.0; 39 * 36 + 36], 36, a, b);
    }
}
