//! The judge: how likely a ball of any radius at any place solves the scene, for all of them at once.
//!
//! An hourglass with skip connections: what each halving saw is handed to the doubling of the same size, so that
//! the answer is sharp where the scene is. Out come maps of logits, one for each of a few radii. It learns from balls
//! with their outcome (`labels`); the paper has no such net. Ordered by it, proposals need fewer attempts.

use burn::module::Module;
use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::{Device, Tensor};

use super::conv::{double, doubling, halve, halving};
use crate::puzzle::action::{Ball, RADIUS};
use crate::puzzle::scene::SIZE;
use crate::raster::{CELLS, CHANNELS, SIDE, cell_centre};

/// Radii that the judge has a map for, evenly spaced from the smallest to the largest.
pub const RADII: usize = 8;

/// Channels after each of the five convolutions.
const WIDTHS: [usize; 5] = [16, 32, 64, 64, 96];

/// A net from the channels of a scene to `RADII` maps of logits.
#[derive(Module, Debug)]
pub struct Judge {
    down: Vec<Conv2d>,
    up: Vec<ConvTranspose2d>,
}

impl Judge {
    /// A fresh judge.
    pub fn new(device: &Device) -> Judge {
        let down = (0..WIDTHS.len()).map(|layer| {
            let input = if layer == 0 { CHANNELS } else { WIDTHS[layer - 1] };
            halving(input, WIDTHS[layer], 4, device)
        });
        let up = (0..WIDTHS.len()).rev().map(|layer| {
            // But for the innermost, a doubling sees the one before and what was seen at its size on the way down.
            let input = if layer == WIDTHS.len() - 1 { WIDTHS[layer] } else { 2 * WIDTHS[layer] };
            doubling(input, if layer == 0 { RADII } else { WIDTHS[layer - 1] }, 4, device)
        });
        Judge { down: down.collect(), up: up.collect() }
    }

    /// Logits of the maps. `[batch, 5, 64, 64]` in, `[batch, RADII, 64, 64]` out.
    pub fn forward(&self, scene: Tensor<4>) -> Tensor<4> {
        let mut seen = Vec::with_capacity(self.down.len());
        let mut x = scene;
        for layer in &self.down {
            x = halve(layer, x);
            seen.push(x.clone());
        }
        seen.pop();
        for layer in &self.up {
            x = double(layer, x, !seen.is_empty());
            if let Some(before) = seen.pop() {
                x = Tensor::cat(vec![x, before], 1);
            }
        }
        x
    }
}

/// Where a ball is judged: its index among the numbers of a `[RADII, 64, 64]` picture.
pub fn index(ball: Ball) -> usize {
    let cell = |at: f64| (at * SIDE as f64 / SIZE) as usize;
    let share = (ball.r - RADIUS.start()) / (RADIUS.end() - RADIUS.start());
    let radius = (share * (RADII - 1) as f64).round() as usize;
    radius * CELLS + cell(ball.y) * SIDE + cell(ball.x)
}

/// The ball in the middle of those that are judged by this number.
pub fn ball(index: usize) -> Ball {
    let [x, y] = cell_centre(index % CELLS);
    let share = (index / CELLS) as f64 / (RADII - 1) as f64;
    let r = RADIUS.start() + share * (RADIUS.end() - RADIUS.start());
    Ball { x, y, r }
}
