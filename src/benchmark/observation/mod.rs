//! PHYRE's observations of a simulation: images of colour codes, and the features of its objects.
//!
//! A rollout is observed after its first step and then every `stride` steps. Written for the Python package, which has
//! PHYRE's interface; this project's nets use the images of `raster`. The images are identical to PHYRE's, pixel by
//! pixel.

use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Rollout;
use crate::puzzle::scene::{Body, Scene};

pub mod colour_codes;
pub mod features;

/// PHYRE's `DEFAULT_STRIDE`: one observation per second.
pub const DEFAULT_STRIDE: usize = 60;

/// px per metre (PHYRE). The same as in the simulator, which this folder does not use.
const PX_PER_METRE: f32 = 6.0;

/// Returns PHYRE's objects: the bodies of a scene, followed by the ball if there is one.
pub fn objects(scene: &Scene, ball: Option<Ball>) -> Vec<Body> {
    scene.bodies.iter().cloned().chain(ball.map(|ball| ball.body())).collect()
}

/// Returns the steps at which a rollout is observed: 1, 1 + stride and so on.
pub fn observed_steps(rollout: &Rollout, stride: usize) -> impl ExactSizeIterator<Item = usize> + use<> {
    (1..rollout.steps + 1).step_by(stride.max(1))
}

/// Moves the objects of a rollout to their poses after a step.
///
/// # Panics
///
/// If the rollout does not belong to these objects, or has fewer steps.
pub fn move_to_step(objects: &mut [Body], rollout: &Rollout, step: usize) {
    for body in objects.iter_mut().filter(|body| !body.dynamic) {
        body.x = through_metres(body.x);
        body.y = through_metres(body.y);
        body.angle = f64::from(body.angle as f32);
    }
    for (&index, pose) in rollout.bodies.iter().zip(rollout.row(step)) {
        let body = &mut objects[index];
        [body.x, body.y, body.angle] = pose.map(f64::from);
    }
}

/// Returns a coordinate as the engine reports it, px: f32, converted to metres and back.
fn through_metres(px: f64) -> f64 {
    f64::from(px as f32 / PX_PER_METRE * PX_PER_METRE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_observation_follows_the_first_step() {
        let steps = |steps, stride| {
            let rollout = Rollout { solved: false, steps, bodies: vec![], poses: vec![], touching: vec![] };
            observed_steps(&rollout, stride).collect::<Vec<_>>()
        };
        assert_eq!(steps(1000, 60).len(), 17);
        assert_eq!(steps(1000, 60)[16], 961);
        assert_eq!(steps(181, 60), [1, 61, 121, 181]);
        assert_eq!(steps(3, 1), [1, 2, 3]);
        assert_eq!(steps(3, usize::MAX), [1]);
    }
}
