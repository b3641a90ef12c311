//! Random balls: uniform over the action space, and Gaussian noise around a known one.
//!
//! All draws come from the caller's generator, so that they depend only on its seed.

use rand::{Rng, RngExt};

use crate::puzzle::action::{Action, Ball};
use crate::puzzle::scene::Scene;

/// A valid ball drawn uniformly from the action space.
pub fn random_ball(scene: &Scene, rng: &mut impl Rng) -> Ball {
    loop {
        let action = Action { x: rng.random(), y: rng.random(), r: rng.random() };
        if let Ok(ball) = action.place(scene) {
            return ball;
        }
    }
}

/// An action moved by Gaussian noise; a radius that leaves its range stops at the end of it.
pub fn perturbed(start: Action, deviation: f64, rng: &mut impl Rng) -> Action {
    let mut near = |value: f64| value + deviation * gaussian(rng);
    Action { x: near(start.x), y: near(start.y), r: near(start.r).clamp(0.0, 1.0) }
}

/// One draw of mean 0 and deviation 1 (Box and Muller), from libm, so that wasm draws the same.
fn gaussian(rng: &mut impl Rng) -> f64 {
    let (u, v): (f64, f64) = (1.0 - rng.random::<f64>(), rng.random());
    libm::sqrt(-2.0 * libm::log(u)) * libm::cos(std::f64::consts::TAU * v)
}
