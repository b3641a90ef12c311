//! Training samples of the four nets: the channels of a scene, and the target maps of one known solution.
//!
//! A solution is a task and a ball; simulating it produces the target maps. Used by training; uses neither burn
//! nor files.

use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::scene::Scene;
use crate::raster::{Bitmap, CHANNELS, ball_image, path_image, scene_channels};
use crate::simulator::simulate;

/// The sample of one solution: 9 images of 512 bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Input of the nets: green object, blue goal, purple goal, gray, black.
    pub scene: [Bitmap; CHANNELS],
    /// Target maps: base path, target path, action path, placement.
    pub targets: [Bitmap; 4],
}

impl Sample {
    /// Returns the sample of a ball that solves a scene, from two rollouts: one without the ball and one with it.
    ///
    /// # Errors
    /// If the ball may not be placed in the scene.
    pub fn new(scene: &Scene, ball: Ball) -> Result<Sample, Invalid> {
        let (without, with) = (simulate(scene, None)?, simulate(scene, Some(ball))?);
        let object = &scene.bodies[scene.body1];
        let targets = [
            path_image(object, &without, scene.body1),
            path_image(object, &with, scene.body1),
            path_image(&ball.body(), &with, scene.bodies.len()),
            ball_image(ball),
        ];
        Ok(Sample { scene: scene_channels(scene), targets })
    }
}
