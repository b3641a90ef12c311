//! The dynamics net: imagines for any ball where the green object and the ball go, and how likely it solves the scene.
//!
//! A forward model of the scene's dynamics that is conditioned on an action (Ahmed et al. 2021, "Physical Reasoning
//! Using Dynamics-Aware Models", show that such knowledge helps to choose actions). A U-Net reads the covered share of
//! each cell once; a small perceptron then answers for each ball from the hypercolumn at its place (Hariharan et al.
//! 2015: the features of all sizes), its exact position and its radius. So a ball costs little, and hundreds are
//! imagined at once. It also returns one map of logits for each of a few radii, as the success net does: they say which
//! balls are worth imagining.

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

/// The levels of the hypercolumn, finest first: side and channels. Those with a skip connection have the channels of
/// decoder and encoder.
pub const LEVELS: [(usize, usize); 5] = [
    (SIDE, FINEST),
    (SIDE / 2, 2 * WIDTHS[0]),
    (SIDE / 4, 2 * WIDTHS[1]),
    (SIDE / 8, 2 * WIDTHS[2]),
    (SIDE / 16, 2 * WIDTHS[3]),
];

/// Values of the code, the innermost output of the encoder: 2 x 2 cells.
pub const CODE: usize = 4 * WIDTHS[4];

/// A net from the covered shares of a scene's cells and balls in it to their paths and chances.
#[derive(Module, Debug)]
pub struct DynamicsNet {
    down: Vec<Conv2d>,
    up: Vec<ConvTranspose2d>,
    pub(super) head: BallHead,
}

/// What the U-Net makes of scenes.
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

    /// The logits of the cells alone, `[batch, RADII, 64, 64]`: the last layer leaves out the features of balls.
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

    /// Scenes `[batch, 5, 64, 64]` and balls in them, in; the logits of all cells and what each ball leads to, out.
    pub fn forward(&self, scenes: Tensor<4>, balls: BallTensors) -> (Tensor<4>, Predictions<Tensor<2>>) {
        let features = self.encode(scenes);
        let predictions = self.head.forward(&features, balls);
        (features.logits, predictions)
    }
}
