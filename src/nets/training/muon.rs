//! Muon (Jordan et al. 2024) for the weights of linear layers and convolutions. burn's Muon accepts only matrices, so
//! the weights of a convolution are reshaped, one row for each index of their first dimension.
//!
//! Muon replaces the momentum of a matrix by an orthogonal matrix close to it, so that all directions learn equally
//! fast. Biases, and the last layers of the chances, which have a single output, keep Adam.

use burn::module::ParamGroup;
use burn::optim::momentum::{Momentum, MomentumConfig, MomentumState};
use burn::optim::{AdjustLrFn, LearningRate, ModuleOptimizer, Muon, MuonConfig, MuonState, Optimizer};
use burn::tensor::{Device, Tensor};

use super::adam::FusedAdam;

/// Returns Muon for the weights of layers, and Adam for all other parameters. Their steps have a similar size at the
/// same learning rate (Liu et al. 2025, "Muon is Scalable for LLM Training").
pub(super) fn muon_and_adam() -> ModuleOptimizer {
    let weights = ParamGroup::from_predicate("weight").exclude(ParamGroup::from_predicate("logit"));
    let muon = MuonConfig::new().with_adjust_lr_fn(AdjustLrFn::MatchRmsAdamW).build();
    ModuleOptimizer::from(FusedAdam).with_group(weights, MuonOfMatrices(muon), None)
}

/// Applies burn's Muon, which accepts only matrices.
#[derive(Clone)]
struct MuonOfMatrices(Muon);

impl Optimizer for MuonOfMatrices {
    type State<const D: usize> = MuonState<2>;

    fn step<const D: usize>(
        &self,
        learning_rate: LearningRate,
        tensor: Tensor<D>,
        gradient: Tensor<D>,
        state: Option<MuonState<2>>,
    ) -> (Tensor<D>, Option<MuonState<2>>) {
        let shape = tensor.dims();
        let rows = shape[0] as i32;
        let matrix = |tensor: Tensor<D>| tensor.reshape([rows, -1]);
        let (tensor, state) = self.0.step(learning_rate, matrix(tensor), matrix(gradient), state);
        let state = state.map(|state| without_negligible(state, tensor.zeros_like()));
        (tensor.reshape(shape), state)
    }

    fn to_device<const D: usize>(state: MuonState<2>, device: &Device) -> MuonState<2> {
        <Muon as Optimizer>::to_device::<2>(state, device)
    }
}

/// Magnitude below which momentum is set to zero. It is far below what rounding leaves of a step, and the products of
/// two numbers of this magnitude are not yet subnormal.
const NEGLIGIBLE: f32 = 1e-18;

/// Sets negligible momentum to zero. That of a weight without a gradient would decay until it is subnormal and then
/// stay so, which makes a step up to three times slower.
fn without_negligible(MuonState { momentum }: MuonState<2>, no_gradient: Tensor<2>) -> MuonState<2> {
    let velocity = velocity(momentum, no_gradient);
    let negligible = velocity.clone().abs().lower_elem(NEGLIGIBLE);
    MuonState::new(MomentumState::new(velocity.mask_fill(negligible, 0.0)))
}

/// burn keeps the velocity to itself, but with a factor of 1 it is what a gradient of 0 becomes.
fn velocity(momentum: MomentumState<2>, no_gradient: Tensor<2>) -> Tensor<2> {
    let unchanged = Momentum::new(&MomentumConfig { momentum: 1.0, dampening: 0.0, nesterov: false });
    unchanged.transform(no_gradient, Some(momentum)).0
}

#[cfg(test)]
mod tests {
    use burn::module::Module;
    use burn::optim::GradientsParams;
    use burn::tensor::Distribution;

    use super::*;
    use crate::nets::{SuccessNet, seeded};
    use crate::raster::{CHANNELS, SIDE};

    /// The singular values of a matrix with orthonormal rows are all 1. Those of a step come close, whatever the
    /// gradient's.
    #[test]
    fn a_step_of_a_convolution_is_a_nearly_orthogonal_matrix() {
        let device = seeded(0);
        let tensor = Tensor::<4>::zeros([16, 5, 4, 4], &device);
        let gradient = Tensor::random([16, 5, 4, 4], Distribution::Normal(0.0, 3.0), &device);
        let muon = MuonOfMatrices(MuonConfig::new().build());
        let (stepped, _) = muon.step(1.0, tensor, gradient, None);
        let step = stepped.reshape([16, 80]);
        let products = step.clone().matmul(step.transpose());
        let values: Vec<f32> = products.into_data().iter().collect();
        for (index, value) in values.iter().enumerate() {
            let expected = if index % 17 == 0 { 1.0 } else { 0.0 };
            assert!((value - expected).abs() < 0.6, "{index}: {value}");
        }
    }

    #[test]
    fn momentum_without_a_gradient_does_not_become_subnormal() {
        let device = seeded(0);
        let (mut tensor, mut state) = (Tensor::<2>::zeros([2, 3], &device), None);
        for step in 0..2000 {
            // Only the first row goes on learning.
            let dead = if step == 0 { 1.0 } else { 0.0 };
            let gradient = Tensor::from_data([[1.0, -2.0, 3.0], [dead, dead, dead]], &device);
            (tensor, state) = MuonOfMatrices(MuonConfig::new().build()).step(1e-3, tensor, gradient, state);
        }
        let velocity = velocity(state.expect("a state").momentum, tensor.zeros_like()).into_data();
        let values: Vec<f32> = velocity.iter().collect();
        assert!(values[..3].iter().all(|value| value.abs() > 1.0), "{values:?}");
        assert_eq!(values[3..], [0.0; 3]);
    }

    #[test]
    fn muon_moves_the_weights_and_adam_the_biases() {
        let device = seeded(0).autodiff();
        let net = SuccessNet::new(&device);
        let scenes = Tensor::random([2, CHANNELS, SIDE, SIDE], Distribution::Uniform(0.0, 1.0), &device);
        let gradients = GradientsParams::from_grads(net.forward(scenes).sum().backward(), &net);
        let before = net.valid();
        let after = muon_and_adam().step(0.01, net, gradients).valid();
        let [old, new] = [&before, &after].map(|net| net.down[1].weight.val());
        let moved = (new - old).powi_scalar(2).mean().sqrt().into_scalar::<f32>();
        // 0.2 sqrt(512) times an orthogonal matrix of 32 rows and 512 columns.
        assert!((moved - 0.002).abs() < 5e-4, "weights moved by {moved}");
        let [old, new] = [&before, &after].map(|net| net.down[1].bias.as_ref().expect("a bias").val());
        let moved = (new - old).abs().max().into_scalar::<f32>();
        assert!((moved - 0.01).abs() < 1e-4, "biases moved by {moved}");
    }
}
