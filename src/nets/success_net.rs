//! The success net: scores all actions at once by how likely a ball of any radius at any position solves the scene.
//!
//! It is a U-Net (`u_net`) that returns one map of logits for each of a few radii, and learns from balls and their
//! outcomes. The paper has no such net. Agents that rank balls by it need fewer attempts.

use burn::module::Module;
use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::{Device, Tensor};

use super::{seeded, u_net};
use crate::puzzle::action::{Ball, Invalid, RADIUS};
use crate::puzzle::scene::SIZE;
use crate::raster::{self, CELLS, SIDE};

/// Number of radii with a map, evenly spaced from the smallest to the largest.
pub const RADII: usize = 8;

/// A net from the covered shares of a scene's cells to `RADII` maps of logits.
#[derive(Module, Debug)]
pub struct SuccessNet {
    pub(super) down: Vec<Conv2d>,
    pub(super) up: Vec<ConvTranspose2d>,
}

impl SuccessNet {
    /// Returns a fresh success net with random weights from this seed.
    pub fn fresh(seed: u64) -> SuccessNet {
        SuccessNet::new(&seeded(seed))
    }

    pub(super) fn new(device: &Device) -> SuccessNet {
        let (down, up) = u_net::new_layers(RADII, device);
        SuccessNet { down, up }
    }

    /// Returns the logits `[batch, RADII, 64, 64]` of scenes `[batch, 5, 64, 64]`.
    pub fn forward(&self, scene: Tensor<4>) -> Tensor<4> {
        u_net::forward(&self.down, &self.up, scene).last
    }
}

/// Returns the index of the logit that scores a ball, among the values of `[RADII, 64, 64]` logits.
///
/// # Errors
/// If no logit scores the ball: the radius is not in `RADIUS`, or the centre is outside the scene.
pub fn logit_index(ball: Ball) -> Result<usize, Invalid> {
    if !RADIUS.contains(&ball.r) {
        return Err(Invalid::Radius);
    }
    if !(0.0..SIZE).contains(&ball.x) || !(0.0..SIZE).contains(&ball.y) {
        return Err(Invalid::Outside);
    }
    let cell = |at: f64| (at * SIDE as f64 / SIZE) as usize;
    let fraction = (ball.r - RADIUS.start()) / (RADIUS.end() - RADIUS.start());
    let radius = (fraction * (RADII - 1) as f64).round() as usize;
    Ok(radius * CELLS + cell(ball.y) * SIDE + cell(ball.x))
}

/// Returns the ball that is scored by a logit among `[RADII, 64, 64]`: the centre of its cell, and the radius of its
/// map. The inverse of `logit_index` on these balls.
pub fn ball_at(index: usize) -> Ball {
    let [x, y] = raster::cell_centre(index % CELLS);
    let fraction = (index / CELLS) as f64 / (RADII - 1) as f64;
    let r = RADIUS.start() + fraction * (RADIUS.end() - RADIUS.start());
    Ball { x, y, r }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logit_scores_its_own_ball() {
        for index in 0..RADII * CELLS {
            assert_eq!(logit_index(ball_at(index)), Ok(index));
        }
    }

    #[test]
    fn a_ball_belongs_to_the_nearest_logit() {
        let spacing = (RADIUS.end() - RADIUS.start()) / (RADII - 1) as f64;
        for (x, y, r) in [(2.0, 2.0, 2.0), (253.0, 254.0, 32.0), (100.0, 31.0, 7.0), (4.0, 99.0, 20.0)] {
            let centre = ball_at(logit_index(Ball { x, y, r }).expect("a ball in the scene"));
            assert!((centre.x - x).abs() <= 2.0 && (centre.y - y).abs() <= 2.0, "{x}, {y}: {centre}");
            assert!((centre.r - r).abs() <= spacing / 2.0, "{r}: {centre}");
        }
    }

    /// Otherwise a radius of 64 px would have the index of a logit of another scene in the batch.
    #[test]
    fn a_ball_that_no_logit_scores_is_refused() {
        let ball = Ball { x: 100.0, y: 100.0, r: 10.0 };
        for r in [64.0, 32.1, 1.9, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(logit_index(Ball { r, ..ball }), Err(Invalid::Radius), "{r}");
        }
        for at in [-1.0, SIZE, 300.0, f64::NAN] {
            assert_eq!(logit_index(Ball { x: at, ..ball }), Err(Invalid::Outside), "{at}");
            assert_eq!(logit_index(Ball { y: at, ..ball }), Err(Invalid::Outside), "{at}");
        }
    }
}
