//! The dynamics net: imagines the paths of the green object and of any ball, and how likely the ball solves the scene.
//!
//! It is a forward model of the scene's dynamics, conditioned on an action (Ahmed et al. 2021, "Physical Reasoning
//! Using Dynamics-Aware Models", show that such knowledge helps to choose actions). A U-Net reads the covered share of
//! each cell once. For each ball, a small perceptron then predicts the outcome from the hypercolumn at the ball's
//! centre (Hariharan et al. 2015: the features of all sizes), its exact position and its radius. A ball therefore costs
//! little, and hundreds are imagined at once. Like the success net, it also returns one map of logits for each of a few
//! radii, which show which balls are worth imagining.

use burn::module::Module;
use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::activation::relu;
use burn::tensor::{Device, Tensor};

use super::ball_batch::BallTensors;
use super::ball_head::{BallHead, Predictions};
use super::seeded;
use super::success_net::RADII;
use super::u_net::{self, Activations, WIDTHS};
use crate::raster::SIDE;

/// Features of the finest level, 64 x 64.
pub const FINEST: usize = 16;

/// The levels of the hypercolumn, finest first: side and channels. Levels with a skip connection have the channels of
/// both decoder and encoder.
pub const LEVELS: [(usize, usize); 5] = [
    (SIDE, FINEST),
    (SIDE / 2, 2 * WIDTHS[0]),
    (SIDE / 4, 2 * WIDTHS[1]),
    (SIDE / 8, 2 * WIDTHS[2]),
    (SIDE / 16, 2 * WIDTHS[3]),
];

/// Number of values of the code, the innermost output of the encoder: 2 x 2 cells.
pub const CODE: usize = 4 * WIDTHS[4];

/// A net from the covered shares of a scene's cells and the balls in the scene to the balls' paths and chances.
#[derive(Module, Debug)]
pub struct DynamicsNet {
    down: Vec<Conv2d>,
    up: Vec<ConvTranspose2d>,
    pub(super) head: BallHead,
}

/// The U-Net's results for scenes.
pub struct SceneFeatures {
    /// Logits of the balls on each cell, `[batch, RADII, 64, 64]`.
    pub logits: Tensor<4>,
    /// The levels of the hypercolumn in the order of `LEVELS`, each `[batch, channels, side, side]`.
    pub levels: Vec<Tensor<4>>,
    /// `[batch, CODE]`
    pub code: Tensor<2>,
}

impl DynamicsNet {
    /// Returns a fresh net with random weights from this seed.
    pub fn fresh(seed: u64) -> DynamicsNet {
        DynamicsNet::new(&seeded(seed))
    }

    pub(super) fn new(device: &Device) -> DynamicsNet {
        let (down, up) = u_net::new_layers(RADII + FINEST, device);
        DynamicsNet { down, up, head: BallHead::new(device) }
    }

    /// Returns only the logits of the cells, `[batch, RADII, 64, 64]`. The last layer omits the features of balls.
    pub fn cell_logits(&self, scenes: Tensor<4>) -> Tensor<4> {
        let mut up = self.up.clone();
        let last = up.last_mut().expect("five layers");
        last.weight = last.weight.clone().map(|weight| weight.narrow(1, 0, RADII));
        last.bias = last.bias.take().map(|bias| bias.map(|bias| bias.narrow(0, 0, RADII)));
        u_net::forward(&self.down, &up, scenes).last
    }

    /// Reads scenes, `[batch, 5, 64, 64]`.
    pub fn encode(&self, scenes: Tensor<4>) -> SceneFeatures {
        let Activations { last, skipped: mut levels, code } = u_net::forward(&self.down, &self.up, scenes);
        let [logits, finest] = last.split_with_sizes(vec![RADII, FINEST], 1).try_into().expect("two parts");
        levels.push(relu(finest));
        levels.reverse();
        SceneFeatures { logits, levels, code: code.flatten(1, 3) }
    }

    /// Returns the logits of all cells and the predictions for each ball, from scenes `[batch, 5, 64, 64]` and balls in
    /// them.
    pub fn forward(&self, scenes: Tensor<4>, balls: BallTensors) -> (Tensor<4>, Predictions<Tensor<2>>) {
        let features = self.encode(scenes);
        let predictions = self.head.forward(&features, balls);
        (features.logits, predictions)
    }
}
