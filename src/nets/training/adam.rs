//! Adam (Kingma and Ba 2014) in one pass over the parameters.
//!
//! burn's own Adam consists of a dozen tensor operations, each of which reads and writes every parameter. The state is
//! burn's, and a test compares the steps of both.

use burn::optim::{AdamState, AdaptiveMomentumState, LearningRate, Optimizer};
use burn::tensor::{Device, Tensor};
use rayon::prelude::*;

/// Decay rate of the first moment, the mean of the gradients.
const BETA_1: f32 = 0.9;

/// Decay rate of the second moment, the mean of their squares.
const BETA_2: f32 = 0.999;

/// Added to the denominator, so that a step is finite where gradients vanish.
const EPSILON: f32 = 1e-8;

/// Parameters that one core processes at a time: 64 KiB.
const CHUNK: usize = 1 << 14;

/// Adam with the constants of the paper.
#[derive(Clone)]
pub(crate) struct FusedAdam;

impl Optimizer for FusedAdam {
    type State<const D: usize> = AdamState<D>;

    fn step<const D: usize>(
        &self,
        learning_rate: LearningRate,
        tensor: Tensor<D>,
        gradient: Tensor<D>,
        state: Option<AdamState<D>>,
    ) -> (Tensor<D>, Option<AdamState<D>>) {
        let device = tensor.device();
        let (time, first_moment, second_moment) = match state {
            Some(AdamState { momentum }) => (momentum.time + 1, momentum.moment_1, momentum.moment_2),
            None => (1, tensor.zeros_like(), tensor.zeros_like()),
        };
        let bias = |beta: f32| 1.0 - beta.powi(time as i32);
        let (step_size, correction) = (learning_rate as f32 / bias(BETA_1), 1.0 / bias(BETA_2).sqrt());
        let (mut tensor, gradient) = (tensor.into_data(), gradient.into_data());
        let (mut first_moment, mut second_moment) = (first_moment.into_data(), second_moment.into_data());
        let f32s = "the parameters are f32";
        let chunks = tensor.as_mut_slice::<f32>().expect(f32s).par_chunks_mut(CHUNK);
        chunks
            .zip(gradient.as_slice::<f32>().expect(f32s).par_chunks(CHUNK))
            .zip(first_moment.as_mut_slice::<f32>().expect(f32s).par_chunks_mut(CHUNK))
            .zip(second_moment.as_mut_slice::<f32>().expect(f32s).par_chunks_mut(CHUNK))
            .for_each(|(((values, gradients), first), second)| {
                for (((value, gradient), m), v) in values.iter_mut().zip(gradients).zip(first).zip(second) {
                    *m += (gradient - *m) * (1.0 - BETA_1);
                    *v += (gradient * gradient - *v) * (1.0 - BETA_2);
                    *value -= step_size * *m / (v.sqrt() * correction + EPSILON);
                }
            });
        let back = |data| Tensor::from_data(data, &device);
        let momentum = AdaptiveMomentumState::new(time, back(first_moment), back(second_moment));
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
    fn steps_agree_with_burns_adam() {
        let device = Device::flex();
        let burns = AdamConfig::new().with_epsilon(EPSILON).build();
        let start = Tensor::<1>::from_floats([0.5, -2.0, 1e-3, 4.0], &device);
        let (mut ours, mut theirs) = ((start.clone(), None), (start.clone(), None));
        for step in 0..5 {
            let gradient = Tensor::<1>::from_floats([1.0 - 0.3 * step as f32, 1e-4, 0.0, -7.0], &device);
            ours = FusedAdam.step(3e-3, ours.0, gradient.clone(), ours.1);
            theirs = burns.step(3e-3, theirs.0, gradient, theirs.1);
        }
        let moved = (ours.0.clone() - start).abs().max().into_scalar::<f32>();
        let apart = (ours.0 - theirs.0).abs().max().into_scalar::<f32>();
        assert!(moved > 1e-3 && apart < 1e-6, "moved by {moved}, apart by {apart}");
    }
}
