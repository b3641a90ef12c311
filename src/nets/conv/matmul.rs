//! The matrix product of the layers with few cells: our own loops for one scene, the gemm crate for batches.
//!
//! gemm first packs both matrices into tiles. This pays off for batches, where its products also include those of the
//! weight gradients. For one scene, each weight is read only once or a few times, and packing costs more than the sums:
//! `few_columns` reads the weights in place. Used by `forward` and `backward`.

use pulp::{Simd, WithSimd, bytemuck};

use super::simd::{lanes_that_divide, load, multiply_add, vectorize};

/// Rows of `a` that `few_columns` processes at once. The number of rows must be a multiple of this, unless `b` is one
/// column and `a` is transposed.
pub(crate) const TILE_ROWS: usize = 8;

/// Lanes of the widest registers.
const WIDEST: usize = 16;

/// Columns of a transposed matrix, contiguous in memory, that `rows_in_registers` reads at once.
const DEPTH: usize = 8;

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
    let across_columns = !(b.columns == 1 || fits_scalar_products(a, b) || fits_rows(a, b));
    let lanes = if across_columns { lanes_that_divide(b.columns) } else { WIDEST };
    vectorize(lanes, FewColumns { out, stride, a, b });
}

/// Returns whether `scalar_products` can multiply them.
fn fits_scalar_products(a: Matrix, b: Matrix) -> bool {
    a.column_stride == 1 && matches!(b.columns, 1 | 4)
}

/// Returns whether `rows_in_registers` can multiply them.
fn fits_rows(a: Matrix, b: Matrix) -> bool {
    b.columns == 4 && a.row_stride == 1 && a.rows.is_multiple_of(WIDEST) && a.columns.is_multiple_of(DEPTH)
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
        if fits_scalar_products(a, b) {
            // Eight registers of sums, as many as wasm has registers for besides the factors; sixteen of AVX-512's.
            match (S::F32_LANES, b.columns) {
                (16, 1) => scalar_products::<S, 1, 8, 1>(simd, out, stride, a, b),
                (16, _) => scalar_products::<S, 1, 4, 4>(simd, out, stride, a, b),
                (8, 1) => scalar_products::<S, 2, 4, 1>(simd, out, stride, a, b),
                (8, _) => scalar_products::<S, 2, 2, 2>(simd, out, stride, a, b),
                (_, 1) => scalar_products::<S, 4, 2, 1>(simd, out, stride, a, b),
                _ => scalar_products::<S, 4, 1, 2>(simd, out, stride, a, b),
            }
        } else if b.columns == 1 {
            transposed_by_column(out, stride, a, b);
        } else if fits_rows(a, b) {
            rows_in_registers::<S>(simd, out, stride, a, b);
        } else if b.columns == S::F32_LANES && a.row_stride == 1 && a.columns.is_multiple_of(4) {
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
                        multiply_add::<S, false, _>(simd, &mut sums[index], rows[index][k], right);
                    }
                }
            } else {
                for k in 0..a.columns {
                    let right = right(k);
                    let left = &a.data[k * a.column_stride + row..][..ROWS];
                    for index in 0..ROWS {
                        multiply_add::<S, false, _>(simd, &mut sums[index], left[index], right);
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

/// Multiplies a transposed matrix by four columns, a few of its columns at a time, so that memory is read in order. A
/// register holds the sums of neighbouring rows in one column.
#[inline(always)]
fn rows_in_registers<S: Simd>(simd: S, out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    let mut totals = vec![0.0; 4 * a.rows];
    for k in (0..a.columns).step_by(DEPTH) {
        let left: [&[f32]; DEPTH] = std::array::from_fn(|index| &a.data[(k + index) * a.column_stride..][..a.rows]);
        let right: [&[f32]; DEPTH] = std::array::from_fn(|index| &b.data[(k + index) * b.row_stride..][..4]);
        for (row, totals) in totals.chunks_exact_mut(4 * S::F32_LANES).enumerate() {
            let totals = S::as_mut_simd_f32s(totals).0;
            let mut sums: [S::f32s; 4] = std::array::from_fn(|column| totals[column]);
            for index in 0..DEPTH {
                let left = load::<S>(left[index], row * S::F32_LANES);
                for column in 0..4 {
                    multiply_add::<S, false, _>(
                        simd,
                        std::array::from_mut(&mut sums[column]),
                        right[index][column],
                        [left],
                    );
                }
            }
            totals.copy_from_slice(&sums);
        }
    }
    for (row, totals) in totals.chunks_exact(4 * S::F32_LANES).enumerate() {
        for lane in 0..S::F32_LANES {
            let out = &mut out[(row * S::F32_LANES + lane) * stride..][..4];
            for column in 0..4 {
                out[column] = totals[column * S::F32_LANES + lane];
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
                multiply_add::<S, false, _>(simd, &mut sum, left[row], [right]);
            }
            *out = sum[0];
        }
    }
}

/// Multiplies a transposed matrix by one column.
#[inline(always)]
fn transposed_by_column(out: &mut [f32], stride: usize, a: Matrix, b: Matrix) {
    let right: Vec<f32> = (0..b.rows).map(|k| b.data[k * b.row_stride]).collect();
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

/// Multiplies a matrix by one column or four, `ROWS` rows and `COLUMNS` columns at a time. Each element is a scalar
/// product of `WIDEST` partial sums, which take `REGISTERS` registers.
#[expect(clippy::needless_range_loop, reason = "iterators make the code slower")]
#[inline(always)]
fn scalar_products<S: Simd, const REGISTERS: usize, const ROWS: usize, const COLUMNS: usize>(
    simd: S,
    out: &mut [f32],
    stride: usize,
    a: Matrix,
    b: Matrix,
) {
    assert!(a.rows.is_multiple_of(ROWS) && b.columns.is_multiple_of(COLUMNS), "whole tiles");
    let depth = a.columns;
    let mut columns = vec![0.0; b.columns * depth];
    for (column, values) in columns.chunks_exact_mut(depth).enumerate() {
        for (value, row) in values.iter_mut().zip(b.data.chunks(b.row_stride)) {
            *value = row[column];
        }
    }
    let whole = depth / WIDEST * WIDEST;
    for row in (0..a.rows).step_by(ROWS) {
        let left: [&[f32]; ROWS] = std::array::from_fn(|index| &a.data[(row + index) * a.row_stride..][..depth]);
        for column in (0..b.columns).step_by(COLUMNS) {
            let right: [&[f32]; COLUMNS] = std::array::from_fn(|index| &columns[(column + index) * depth..][..depth]);
            let mut sums = [[[simd.splat_f32s(0.0); REGISTERS]; COLUMNS]; ROWS];
            for at in (0..whole).step_by(WIDEST) {
                for register in 0..REGISTERS {
                    let at = at + register * S::F32_LANES;
                    let right: [S::f32s; COLUMNS] = std::array::from_fn(|column| load::<S>(right[column], at));
                    for row in 0..ROWS {
                        let left = load::<S>(left[row], at);
                        for column in 0..COLUMNS {
                            let sum = &mut sums[row][column][register];
                            *sum = simd.add_f32s(*sum, simd.mul_f32s(left, right[column]));
                        }
                    }
                }
            }
            // A copy, so that the sums of the loop stay in registers.
            let sums = sums;
            for (row, (sums, left)) in (row..).zip(sums.iter().zip(left)) {
                for (column, (sums, right)) in (column..).zip(sums.iter().zip(right)) {
                    let pairs = left[whole..].iter().zip(&right[whole..]);
                    let rest: f32 = pairs.map(|(left, right)| left * right).sum();
                    out[row * stride + column] = sum(bytemuck::cast_slice(sums)) + rest;
                }
            }
        }
    }
}

/// Adds the halves of `WIDEST` values until one is left.
#[inline(always)]
fn sum(values: &[f32]) -> f32 {
    let eight: [f32; 8] = std::array::from_fn(|index| values[index] + values[index + 8]);
    let four: [f32; 4] = std::array::from_fn(|index| eight[index] + eight[index + 4]);
    (four[0] + four[2]) + (four[1] + four[3])
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;

    fn values(count: usize) -> Vec<f32> {
        (0..count).map(|i| ((i * 37 % 101) as f32 - 50.0) / 50.0).collect()
    }

    /// The shapes that occur for one scene: tiles, four columns, one column; weights as stored and transposed.
    #[test]
    fn the_loops_for_few_columns_agree_with_gemm() {
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

    /// Maps must be the same on every machine and in wasm, whose registers have four lanes.
    #[test]
    fn the_number_of_lanes_changes_no_bit() {
        for (rows, depth, columns) in [(64, 512, 16), (128, 1024, 4), (256, 512, 1)] {
            let (a, b) = (values(rows * depth), values(depth * columns));
            let b = Matrix::new(&b, depth, columns, columns);
            for a in [Matrix::new(&a, rows, depth, depth), Matrix::new(&a, depth, rows, rows).transposed()] {
                let mut wide = vec![0.0; rows * columns];
                let mut narrow = wide.clone();
                few_columns(&mut wide, columns, a, b);
                Simd::vectorize(pulp::Scalar128b, FewColumns { out: &mut narrow, stride: columns, a, b });
                assert!(wide == narrow, "{rows} x {depth} x {columns}");
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
