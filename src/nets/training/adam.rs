//! Adam (Kingma and Ba 2014) in one pass over the numbers.
//!
//! burn's own composes it of a dozen tensor operations, each of which reads and writes every number. The state is
//! burn's, and a test holds the two together.

use burn::optim::{AdamState, AdaptiveMomentumState, LearningRate, Optimizer};
use burn::tensor::{Device, Tensor};
use rayon::prelude::*;

/// Decay of the mean of the gradients.
const BETA_1: f32 = 0.9;

/// Decay of the mean of their squares.
const BETA_2: f32 = 0.999;

/// Keeps a step finite where gradients vanish.
const EPSILON: f32 = 1e-8;

/// Numbers that one core takes at a time.
const CHUNK: usize = 1 << 14;

/// Adam with the usual constants.
#[derive(Clone)]
pub struct FusedAdam;

impl Optimizer for FusedAdam {
    type State<const D: usize> = AdamState<D>;

    fn step<const D: usize>(
        &self,
        rate: LearningRate,
        tensor: Tensor<D>,
        gradient: Tensor<D>,
        state: Option<AdamState<D>>,
    ) -> (Tensor<D>, Option<AdamState<D>>) {
        let device = tensor.device();
        let (time, means, squares) = match state {
            Some(AdamState { momentum }) => (momentum.time + 1, momentum.moment_1, momentum.moment_2),
            None => (1, tensor.zeros_like(), tensor.zeros_like()),
        };
        let bias = |beta: f32| 1.0 - beta.powi(time as i32);
        let (rate, correction) = (rate as f32 / bias(BETA_1), 1.0 / bias(BETA_2).sqrt());
        let (mut tensor, gradient) = (tensor.into_data(), gradient.into_data());
        let (mut means, mut squares) = (means.into_data(), squares.into_data());
        let numbers = "the parameters are f32";
        let chunks = tensor.as_mut_slice::<f32>().expect(numbers).par_chunks_mut(CHUNK);
        chunks
            .zip(gradient.as_slice::<f32>().expect(numbers).par_chunks(CHUNK))
            .zip(means.as_mut_slice::<f32>().expect(numbers).par_chunks_mut(CHUNK))
            .zip(squares.as_mut_slice::<f32>().expect(numbers).par_chunks_mut(CHUNK))
            .for_each(|(((values, slopes), means), squares)| {
                for (((value, slope), mean), square) in values.iter_mut().zip(slopes).zip(means).zip(squares) {
                    *mean += (slope - *mean) * (1.0 - BETA_1);
                    *square += (slope * slope - *square) * (1.0 - BETA_2);
                    *value -= rate * *mean / (square.sqrt() * correction + EPSILON);
                }
            });
        let back = |data| Tensor::from_data(data, &device);
        let momentum = AdaptiveMomentumState::new(time, back(means), back(squares));
        (back(tensor), Some(AdamState::new(momentum)))
    }

    fn to_device<const D: usize>(mut state: AdamState<D>, device: &Device) -> AdamState<D> {
        state.momentum = state.momentum.to_device(device);
        state
    }
}

#[cfg(test)]
mod tests {
    use burn::optim::AdamConfig;

    use super::*;

    #[test]
    fn steps_are_those_of_burns_own() {
        let device = Device::flex();
        let burns = AdamConfig::new().with_epsilon(EPSILON).build();
        let start = Tensor::<1>::from_floats([0.5, -2.0, 1e-3, 4.0], &device);
        let (mut ours, mut theirs) = ((start.clone(), None), (start.clone(), None));
        for turn in 0..5 {
            let gradient = Tensor::<1>::from_floats([1.0 - 0.3 * turn as f32, 1e-4, 0.0, -7.0], &device);
            ours = FusedAdam.step(3e-3, ours.0, gradient.clone(), ours.1);
            theirs = burns.step(3e-3, theirs.0, gradient, theirs.1);
        }
        let moved = (ours.0.clone() - start).abs().max().into_scalar::<f32>();
        let apart = (ours.0 - theirs.0).abs().max().into_scalar::<f32>();
        assert!(moved > 1e-3 && apart < 1e-6, "moved by {moved}, apart by {apart}");
    }
}
