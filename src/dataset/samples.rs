//! What the nets learn from: a scene as they see it, and the four pictures of one known solution of it.
//!
//! A solution is a task and a ball; the pictures follow from it by simulation. Used by training; knows nothing
//! of burn or files.

use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::scene::Scene;
use crate::raster::{Bitmap, CHANNELS, ball_image, path_image, scene_channels};
use crate::simulator::simulate;

/// The pictures of one solution. 9 x 512 bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// What the nets are given: green object, blue goal, purple goal, gray, black.
    pub scene: [Bitmap; CHANNELS],
    /// What they have to imagine: base path, target path, action path, placement.
    pub imagined: [Bitmap; 4],
}

impl Sample {
    /// The sample of a ball that solves a scene: two rollouts, one without the ball and one with it.
    ///
    /// # Errors
    /// Says why the ball may not be there.
    pub fn new(scene: &Scene, ball: Ball) -> Result<Sample, Invalid> {
        let (without, with) = (simulate(scene, None)?, simulate(scene, Some(ball))?);
        let object = &scene.bodies[scene.body1];
        let imagined = [
            path_image(object, &without, scene.body1),
            path_image(object, &with, scene.body1),
            path_image(&ball.body(), &with, scene.bodies.len()),
            ball_image(ball),
        ];
        Ok(Sample { scene: scene_channels(scene), imagined })
    }
}
