//! The products of a linear layer with a few columns, for the perceptron of the dynamics net.
//!
//! Most of its inputs have passed through a ReLU. Rows of zeros, which add nothing to any sum, are skipped. The
//! remaining rows are multiplied and added in order, so the sums equal those of `matmul`, bit for bit. Used by
//! `imagined_balls`.

use pulp::{Simd, WithSimd};

use super::simd::{load, multiply_add, vectorize};

/// Outputs of a tile. With two registers of columns this makes eight sums, as many as wasm has registers for besides
/// the factors.
const OUTPUTS: usize = 4;

/// Columns of a product: two registers.
pub(crate) const COLUMNS: usize = if cfg!(target_arch = "wasm32") { 8 } else { 16 };

/// The weights of a layer in panels of a few outputs, so that a tile reads them in order.
pub(crate) struct Panels {
    /// The panels, each `[inputs, OUTPUTS]`; the last is padded with zeros.
    weights: Vec<Vec<[f32; OUTPUTS]>>,
    inputs: usize,
    outputs: usize,
}

impl Panels {
    /// Creates panels from finite weights `[inputs, outputs]`.
    pub(crate) fn new(weight: &[f32], outputs: usize) -> Panels {
        let panel = |first: usize| {
            let rows = weight.chunks_exact(outputs).map(move |row| &row[first..outputs.min(first + OUTPUTS)]);
            let padded = rows.map(|row| std::array::from_fn(|index| row.get(index).copied().unwrap_or_default()));
            padded.collect()
        };
        let inputs = weight.len() / outputs;
        Panels { weights: (0..outputs).step_by(OUTPUTS).map(panel).collect(), inputs, outputs }
    }

    /// Returns the number of inputs.
    pub(crate) fn inputs(&self) -> usize {
        self.inputs
    }

    /// Multiplies inputs `[inputs, COLUMNS]` and returns `[outputs, COLUMNS]`.
    pub(crate) fn multiply(&self, x: &[f32]) -> Vec<f32> {
        let (x, _) = x.as_chunks::<COLUMNS>();
        assert!(self.weights.iter().all(|panel| panel.len() == x.len()), "a row for each input");
        // Tests all bits except the sign, so that NaN does not count as zero.
        let is_zero = |row: &[f32; COLUMNS]| row.iter().fold(0, |bits, value| bits | value.to_bits()) << 1 == 0;
        let rows = x.iter().enumerate().filter(|(_, row)| !is_zero(row)).collect();
        let mut y = vec![[0.0; COLUMNS]; self.weights.len() * OUTPUTS];
        vectorize(COLUMNS / 2, Product { panels: &self.weights, rows, y: &mut y });
        y.truncate(self.outputs);
        y.into_flattened()
    }
}

struct Product<'a> {
    panels: &'a [Vec<[f32; OUTPUTS]>],
    /// The rows of the inputs that are not zero, each with its index.
    rows: Vec<(usize, &'a [f32; COLUMNS])>,
    y: &'a mut [[f32; COLUMNS]],
}

impl WithSimd for Product<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Product { panels, rows, y } = self;
        for (panel, y) in panels.iter().zip(y.as_chunks_mut::<OUTPUTS>().0) {
            for column in (0..COLUMNS).step_by(2 * S::F32_LANES) {
                let mut sums = [[simd.splat_f32s(0.0); 2]; OUTPUTS];
                for &(input, row) in &rows {
                    let x = [load::<S>(row, column), load::<S>(row, column + S::F32_LANES)];
                    for (sums, weight) in sums.iter_mut().zip(panel[input]) {
                        multiply_add::<S, false, _>(simd, sums, weight, x);
                    }
                }
                for (y, sums) in y.iter_mut().zip(sums) {
                    S::as_mut_simd_f32s(&mut y[column..column + 2 * S::F32_LANES]).0.copy_from_slice(&sums);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::matmul::{Matrix, matmul};
    use super::*;

    #[test]
    fn products_are_those_of_the_matrix_bit_for_bit() {
        let value = |index: usize| (index * 37 % 101) as f32 / 50.0 - 1.0;
        for (inputs, outputs) in [(516, 192), (64, 8), (3, 16)] {
            let weight: Vec<f32> = (0..inputs * outputs).map(value).collect();
            let of_row = |row: usize| {
                (0..COLUMNS).map(move |column| match row % 3 {
                    0 => 0.0,
                    1 => value(row * COLUMNS + column),
                    _ => value(row + 7 * column).max(0.0),
                })
            };
            let x: Vec<f32> = (0..inputs).flat_map(of_row).collect();
            let mut expected = vec![0.0; outputs * COLUMNS];
            let transposed = Matrix::new(&weight, inputs, outputs, outputs).transposed();
            matmul(&mut expected, COLUMNS, transposed, Matrix::new(&x, inputs, COLUMNS, COLUMNS));
            let bits = |values: &[f32]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&Panels::new(&weight, outputs).multiply(&x)), bits(&expected), "{inputs} to {outputs}");
        }
    }

    #[test]
    fn a_last_panel_may_be_smaller_and_what_is_not_a_number_stays() {
        let weight = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let x = [[1.0; COLUMNS], [f32::NAN; COLUMNS]].concat();
        assert!(Panels::new(&weight, 3).multiply(&x).iter().all(|value| value.is_nan()));
        let x = [[1.0; COLUMNS], [0.0; COLUMNS]].concat();
        let rows = Panels::new(&weight, 3).multiply(&x);
        assert_eq!(rows, [[1.0; COLUMNS], [2.0; COLUMNS], [3.0; COLUMNS]].concat());
    }
}
