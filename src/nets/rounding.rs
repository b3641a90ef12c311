//! Rounds weights so that they compress: `pathlight-lab publish weights` applies this to the weights that the page
//! downloads.
//!
//! Every weight becomes a multiple of its tensor's step, a power of two that depends on the standard deviation of the
//! tensor. Half precision holds such multiples exactly, and nearly all of them fit into a byte (`stored_parameter`).
//! The bits that carry only noise are gone, so brotli also shrinks the file. A uniform step costs the least accuracy
//! for the entropy that it saves: fewer bits of mantissa would keep small weights needlessly precise, and the range of
//! a whole channel would be set by its largest weight, some ten standard deviations.

use burn::module::{Module, ModuleMapper, Param};
use burn::tensor::{Tensor, TensorData};

use super::PathNet;

/// Binary logarithm of the number of steps per standard deviation, which is met within a factor of the square root of
/// two.
const STEPS_PER_DEVIATION: i32 = 5;

impl PathNet {
    /// Returns the nets with rounded weights. Biases, which are few, are unchanged.
    pub fn rounded(self) -> PathNet {
        self.map(&mut Rounding)
    }
}

struct Rounding;

impl ModuleMapper for Rounding {
    fn map_float<const D: usize>(&mut self, param: Param<Tensor<D>>) -> Param<Tensor<D>> {
        if D == 1 {
            return param;
        }
        param.map(|tensor| {
            let shape = tensor.dims();
            let device = tensor.device();
            let mut weights: Vec<f32> = tensor.into_data().iter().collect();
            round(&mut weights);
            Tensor::from_data(TensorData::new(weights, shape), &device)
        })
    }
}

/// Rounds the weights of a tensor. Weights that are all equal or not finite have no such step and are unchanged.
fn round(weights: &mut [f32]) {
    let step = step(weights);
    if step.is_normal() {
        // Adding 0.0 removes negative zero, which is not a multiple of a step.
        weights.iter_mut().for_each(|weight| *weight = (*weight / step).round_ties_even() * step + 0.0);
    }
}

fn step(weights: &[f32]) -> f32 {
    let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / weights.len() as f64;
    let average = mean(&mut weights.iter().map(|&weight| f64::from(weight)));
    let variance = mean(&mut weights.iter().map(|&weight| (f64::from(weight) - average).powi(2)));
    (variance.sqrt().log2().round() as f32 - STEPS_PER_DEVIATION as f32).exp2()
}

#[cfg(test)]
mod tests {
    use half::f16;

    use super::*;

    #[test]
    fn weights_become_multiples_of_a_step_that_half_precision_holds() {
        let weights: Vec<f32> = (-500..=500_i16).map(|index| f32::from(index) / 4000.0).collect();
        let mut rounded = weights.clone();
        round(&mut rounded);
        // The weights spread evenly up to 1/8, with a standard deviation of 0.072, which is nearest to 1/16.
        let step = 1.0 / 16.0 / 32.0;
        assert_eq!(super::step(&weights), step);
        for (weight, rounded) in weights.iter().zip(&rounded) {
            assert!((weight - rounded).abs() <= step / 2.0, "{weight} becomes {rounded}");
            assert_eq!((rounded / step).fract(), 0.0);
            assert_eq!(f16::from_f32(*rounded).to_f32(), *rounded);
        }
        let once = rounded.clone();
        round(&mut rounded);
        assert_eq!(rounded, once);
    }

    #[test]
    fn weights_without_a_deviation_stay() {
        for weight in [0.0, 0.3, f32::NAN, f32::INFINITY] {
            let mut weights = [weight; 4];
            round(&mut weights);
            assert_eq!(weights.map(f32::to_bits), [weight.to_bits(); 4]);
        }
    }
}
