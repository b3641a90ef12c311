//! Linear layers on plain slices, for a few balls at a time. Used by `imagined_balls`.

use burn::nn::Linear;

use super::ball_head::Features;
use super::conv::panels::{COLUMNS, Panels};
use super::logistic::softplus;
use super::values;

/// A linear layer on plain slices.
pub(super) struct Layer {
    weight: Panels,
    bias: Vec<f32>,
}

impl Layer {
    pub(super) fn new(layer: &Linear) -> Layer {
        let bias = values(layer.bias.as_ref().expect("every layer has a bias").val());
        Layer { weight: Panels::new(&values(layer.weight.val()), bias.len()), bias }
    }
}

/// Features of up to `COLUMNS` balls, `[features, COLUMNS]`, one column per ball. Columns without a ball hold arbitrary
/// values.
#[derive(Clone)]
pub(super) struct Columns(pub(super) Vec<f32>);

impl Columns {
    /// Creates columns from the features of each ball, or of any other items.
    pub(super) fn new<'a, B, F: IntoIterator<Item = f32>>(
        balls: &'a [B],
        count: usize,
        features: impl Fn(&'a B) -> F,
    ) -> Columns {
        let mut columns = vec![0.0; count * COLUMNS];
        for (index, ball) in balls.iter().enumerate() {
            for (row, feature) in columns.chunks_exact_mut(COLUMNS).zip(features(ball)) {
                row[index] = feature;
            }
        }
        Columns(columns)
    }

    pub(super) fn get(&self, feature: usize, column: usize) -> f32 {
        self.0[feature * COLUMNS + column]
    }

    fn map(mut self, of: impl Fn(f32) -> f32) -> Columns {
        self.0.iter_mut().for_each(|value| *value = of(*value));
        self
    }
}

impl Features for Columns {
    type Layer = Layer;

    fn linear(&self, Layer { weight, bias }: &Layer) -> Columns {
        let mut y = weight.multiply(&self.0);
        for (y, bias) in y.chunks_exact_mut(COLUMNS).zip(bias) {
            y.iter_mut().for_each(|y| *y += bias);
        }
        Columns(y)
    }

    fn relu(self) -> Columns {
        self.map(|x| if x < 0.0 { 0.0 } else { x })
    }

    fn softplus(mut self) -> Columns {
        softplus(&mut self.0);
        self
    }

    fn add(mut self, other: Columns) -> Columns {
        self.0.iter_mut().zip(other.0).for_each(|(value, other)| *value += other);
        self
    }

    fn concat(blocks: Vec<Columns>) -> Columns {
        Columns(blocks.into_iter().map(|Columns(block)| block).collect::<Vec<_>>().concat())
    }

    fn detach(self) -> Columns {
        self
    }
}
