//! The nets of Harter et al. (2020). Each predicts one map from the scene; the last two also use earlier maps.
//!
//! The base path and the target path are predicted from the scene alone, the action path from the scene and both paths,
//! and the placement of the ball from the scene, the target path and the action path. One more net scores balls: the
//! success net, which reads only the scene, or the dynamics net, which imagines what a ball leads to. This folder is
//! the only user of burn, and its callers need none of burn's types. It uses neither agents nor the simulator, and
//! files only for training checkpoints.

use burn::module::Module;
use burn::tensor::{Device, Tensor, TensorData};

use crate::colour::imagined_maps::ImaginedMap;
use crate::puzzle::scene::Scene;
use crate::raster::{Bitmap, CHANNELS, Coverage, SIDE, scene_channels, scene_coverage};

pub mod ball_batch;
mod ball_columns;
pub mod ball_head;
mod card;
mod conv;
#[cfg(not(target_arch = "wasm32"))]
pub mod dqn;
pub mod dynamics;
mod hourglass;
pub mod imagined_balls;
mod logistic;
mod parameters;
#[cfg(not(target_arch = "wasm32"))]
mod rounding;
mod stored_parameter;
pub mod success_net;
#[cfg(feature = "training")]
pub mod training;
mod u_net;
mod weights;

pub use card::{Card, DqnCard, DynamicsCard, LearnedFrom, Optimiser, OtherFold, PathWeights, SuccessCard};
#[cfg(not(target_arch = "wasm32"))]
pub use dqn::Dqn;
pub use dynamics::DynamicsNet;
pub use hourglass::Hourglass;
pub use imagined_balls::{ImaginedBall, ReadScene};
use logistic::logistic;
pub use parameters::Parameter;
pub use success_net::SuccessNet;
pub use weights::{WeightsError, read_card};

/// The nets of a model.
#[derive(Module, Debug)]
pub struct PathNet {
    base: Hourglass,
    target: Hourglass,
    action: Hourglass,
    placement: Hourglass,
    /// The success net, which is not part of the paper. Weights may lack it.
    pub success: Option<SuccessNet>,
    /// The dynamics net, which is not part of the paper. Weights may lack it.
    pub dynamics: Option<DynamicsNet>,
}

/// Logits of the paper's maps, each `[batch, 1, 64, 64]`, in the order base, target, action, placement.
pub type Logits = [Tensor<4>; 4];

impl PathNet {
    /// Returns fresh nets with random weights from this seed, without a success net or a dynamics net.
    pub fn fresh(seed: u64) -> PathNet {
        PathNet::new(&seeded(seed))
    }

    /// Returns the nets of a weights file, and its card.
    ///
    /// # Errors
    /// If the bytes are not a weights file of these nets.
    pub fn load(bytes: &[u8]) -> Result<(PathNet, Card), WeightsError> {
        PathNet::load_on(bytes, &flex())
    }

    /// Like `load`, but on burn's deprecated ndarray backend: the reference of the differential tests.
    #[cfg(feature = "ndarray")]
    #[allow(deprecated)]
    pub fn load_on_ndarray(bytes: &[u8]) -> Result<(PathNet, Card), WeightsError> {
        PathNet::load_on(bytes, &Device::ndarray())
    }

    fn new(device: &Device) -> PathNet {
        let net = |channels| Hourglass::new(channels, device);
        PathNet {
            base: net(CHANNELS),
            target: net(CHANNELS),
            action: net(CHANNELS + 2),
            placement: net(CHANNELS + 2),
            success: None,
            dynamics: None,
        }
    }

    /// Returns the logits of scenes `[batch, 5, 64, 64]`. Gradients flow through the whole chain.
    pub fn forward(&self, scene: Tensor<4>) -> Logits {
        self.chain(scene).0
    }

    /// Returns the logits, and the maps of the first three nets, which later nets use.
    fn chain(&self, scene: Tensor<4>) -> (Logits, [Tensor<4>; 3]) {
        let base = self.base.forward(scene.clone());
        let target = self.target.forward(scene.clone());
        let base_map = logistic(base.clone());
        let target_map = logistic(target.clone());
        let scene_and_target = Tensor::cat(vec![scene, target_map.clone()], 1); // [batch, 6, 64, 64]
        let action = self.action.forward(Tensor::cat(vec![scene_and_target.clone(), base_map.clone()], 1));
        let action_map = logistic(action.clone());
        let placement = self.placement.forward(Tensor::cat(vec![scene_and_target, action_map.clone()], 1));
        ([base, target, action, placement], [base_map, target_map, action_map])
    }

    /// Returns the maps that the nets predict for a scene.
    ///
    /// ```
    /// use pathlight::{nets::PathNet, puzzle::task::Task};
    ///
    /// let (nets, card) = PathNet::load(&std::fs::read("assets/within-0.safetensors")?)?;
    /// let maps = nets.imagine(&Task::load("00007:008".parse()?)?.scene);
    /// assert_eq!((maps.target.len(), card.dynamics.is_some()), (64 * 64, true));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn imagine(&self, scene: &Scene) -> Imagined {
        let ([.., placement], [base, target, action]) = self.chain(self.encode(scene));
        let [base, target, action, placement] = [base, target, action, logistic(placement)].map(values);
        Imagined { base, target, action, placement }
    }

    /// Returns the logits of the cells of a scene, `[RADII, 64, 64]`, from the success net or otherwise the dynamics
    /// net; `None` if the weights have neither. PHYRE's world is symmetric, so the logits of the scene and of its
    /// mirror image are averaged, which is more accurate than either.
    pub fn cell_logits(&self, scene: &Scene) -> Option<Vec<f32>> {
        let both = |image: Tensor<4>| Tensor::cat(vec![image.clone(), image.flip([3])], 0); // [2, 5, 64, 64]
        let logits = match (&self.success, &self.dynamics) {
            (Some(net), _) => net.forward(both(self.encode_coverage(scene))),
            (None, Some(dynamics)) => dynamics.cell_logits(both(self.encode_coverage(scene))),
            (None, None) => return None,
        }; // [2, RADII, 64, 64]
        let mut logits = values(logits);
        let one = logits.len() / 2;
        let (scene, mirrored) = logits.split_at_mut(one);
        for (row, mirrored) in scene.chunks_exact_mut(SIDE).zip(mirrored.chunks_exact(SIDE)) {
            for (logit, mirrored) in row.iter_mut().zip(mirrored.iter().rev()) {
                *logit = (*logit + mirrored) / 2.0;
            }
        }
        logits.truncate(one);
        Some(logits)
    }

    /// Reads a scene with the dynamics net; `None` if the weights have none.
    pub fn read(&self, scene: &Scene) -> Option<ReadScene> {
        let dynamics = self.dynamics.as_ref()?;
        let images = self.encode_coverage(scene);
        Some(dynamics.read(scene, Tensor::cat(vec![images.clone(), images.flip([3])], 0)))
    }

    /// Returns the input of the paper's nets for a scene, `[1, 5, 64, 64]`.
    fn encode(&self, scene: &Scene) -> Tensor<4> {
        self.image(scene_channels(scene).iter().flat_map(Bitmap::rows).collect::<Vec<_>>().into_flattened())
    }

    /// Returns the input of the success net and of the dynamics net for a scene, `[1, 5, 64, 64]`.
    fn encode_coverage(&self, scene: &Scene) -> Tensor<4> {
        self.image(scene_coverage(scene).iter().flat_map(Coverage::to_f32).collect())
    }

    fn image(&self, channels: Vec<f32>) -> Tensor<4> {
        let device = self.devices().into_iter().next().expect("the nets have parameters");
        Tensor::from_data(TensorData::new(channels, [1, CHANNELS, SIDE, SIDE]), &device)
    }
}

fn values<const D: usize>(tensor: Tensor<D>) -> Vec<f32> {
    tensor.into_data().try_into_vec().expect("the nets are of f32")
}

/// The predicted maps of a scene: 64 x 64 values in 0..=1 each, row 0 at the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Imagined {
    /// Where the green object goes without an action.
    pub base: Vec<f32>,
    /// Where the green object goes in a solution.
    pub target: Vec<f32>,
    /// Where the action ball goes in a solution.
    pub action: Vec<f32>,
    /// Where the action ball starts in a solution.
    pub placement: Vec<f32>,
}

impl Imagined {
    /// Returns a map of the paper's nets; `None` for any other map.
    pub fn map(&self, map: ImaginedMap) -> Option<&[f32]> {
        match map {
            ImaginedMap::Base => Some(&self.base),
            ImaginedMap::Target => Some(&self.target),
            ImaginedMap::Action => Some(&self.action),
            ImaginedMap::Placement => Some(&self.placement),
            ImaginedMap::Success => None,
        }
    }
}

/// Returns the device that all nets run on: burn's flex backend on the CPU.
fn flex() -> Device {
    Device::flex()
}

/// Returns that device with a seeded random number generator.
fn seeded(seed: u64) -> Device {
    let device = flex();
    device.seed(seed);
    device
}
