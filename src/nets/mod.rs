//! The four nets, wired as in Harter et al. (2020): each imagines one stage of a solution from the ones before.
//!
//! Base path and target path come from the scene alone; the action path from those three; the placement of
//! the ball from scene, target path and action path. A fifth net judges balls. This folder is the only user of burn.

use burn::module::Module;
use burn::tensor::activation::sigmoid;
use burn::tensor::{Device, Tensor, TensorData};

use crate::puzzle::scene::Scene;
use crate::raster::{Bitmap, CHANNELS, SIDE, scene_channels};

mod conv;
mod hourglass;
pub mod judge;
#[cfg(not(target_arch = "wasm32"))]
pub mod training;
mod weights;

pub use hourglass::Hourglass;
pub use judge::Judge;
pub use weights::{Card, JudgeCard, WeightsError, read_card};

/// The four nets together.
#[derive(Module, Debug)]
pub struct PathNet {
    base: Hourglass,
    target: Hourglass,
    action: Hourglass,
    placement: Hourglass,
    /// Not the paper's; some weights come without it.
    pub judge: Option<Judge>,
}

/// Logits of the four maps, each `[batch, 1, 64, 64]`, in the order base, target, action, placement.
pub type Logits = [Tensor<4>; 4];

impl PathNet {
    /// Fresh nets.
    pub fn new(device: &Device) -> PathNet {
        let net = |channels| Hourglass::new(channels, device);
        let (base, target) = (net(CHANNELS), net(CHANNELS));
        PathNet { base, target, action: net(CHANNELS + 2), placement: net(CHANNELS + 2), judge: None }
    }

    /// `[batch, 5, 64, 64]` in; gradients flow through the whole chain.
    pub fn forward(&self, scene: Tensor<4>) -> Logits {
        let base = self.base.forward(scene.clone());
        let target = self.target.forward(scene.clone());
        let seen = Tensor::cat(vec![scene, sigmoid(target.clone())], 1); // [batch, 6, 64, 64]
        let action = self.action.forward(Tensor::cat(vec![seen.clone(), sigmoid(base.clone())], 1));
        let placement = self.placement.forward(Tensor::cat(vec![seen, sigmoid(action.clone())], 1));
        [base, target, action, placement]
    }

    /// What the nets imagine of a scene.
    pub fn imagine(&self, scene: &Scene) -> Imagined {
        let [base, target, action, placement] = self.forward(self.tensor(scene)).map(|logits| {
            let map = sigmoid(logits).into_data();
            map.iter::<f32>().collect()
        });
        Imagined { base, target, action, placement }
    }

    /// The judge's logits for a scene, `[RADII, 64, 64]`; `None` if the weights came without a judge. PHYRE's world
    /// is symmetric, so the mean of what it says of the scene and of its mirror image is the better opinion.
    pub fn judged(&self, scene: &Scene) -> Option<Vec<f32>> {
        let judge = self.judge.as_ref()?;
        let scene = self.tensor(scene);
        let logits = judge.forward(Tensor::cat(vec![scene.clone(), scene.flip([3])], 0)); // [2, RADII, 64, 64]
        let [one, other] = logits.chunk(2, 0).try_into().expect("two scenes");
        Some(((one + other.flip([3])) / 2.0).into_data().iter::<f32>().collect())
    }

    /// A scene as the nets see it, `[1, 5, 64, 64]`.
    fn tensor(&self, scene: &Scene) -> Tensor<4> {
        let channels: Vec<f32> = scene_channels(scene).iter().flat_map(Bitmap::to_f32).collect();
        let device = self.devices().into_iter().next().expect("the nets have parameters");
        Tensor::from_data(TensorData::new(channels, [1, CHANNELS, SIDE, SIDE]), &device)
    }
}

/// The four maps of a scene: 64 x 64 values in 0..=1 each, row 0 at the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Imagined {
    /// Where the green object goes if nothing is done.
    pub base: Vec<f32>,
    /// Where it should go.
    pub target: Vec<f32>,
    /// Where the action ball should go.
    pub action: Vec<f32>,
    /// Where the action ball should start.
    pub placement: Vec<f32>,
}

/// The device of this name that nets run on: `flex`, or `ndarray` where the feature is built in.
///
/// # Errors
/// Names the devices there are.
// ndarray is deprecated upstream; it stays as long as it is there to disagree with flex.
#[cfg_attr(feature = "ndarray", allow(deprecated))]
pub fn device(name: &str) -> Result<Device, String> {
    match name {
        "flex" => Ok(Device::flex()),
        #[cfg(feature = "ndarray")]
        "ndarray" => Ok(Device::ndarray()),
        #[cfg(not(feature = "ndarray"))]
        "ndarray" => Err("this build has no ndarray: build it with `--features ndarray`, or use flex".to_string()),
        _ => Err(format!("there is no device `{name}`: use flex or ndarray")),
    }
}
