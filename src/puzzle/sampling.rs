//! Random balls: uniform over the action space, and with Gaussian noise around a known one.
//!
//! All draws come from the caller's generator, so that they depend only on its seed.

use rand::{Rng, RngExt};

use super::action::{Action, Ball, Obstacles};

/// Maximum number of draws for one ball, or for all of `uniform_balls`. In the benchmark's tasks, more than four in ten
/// actions are valid; the limit ends the search in a scene that has no room.
const MAX_DRAWS: usize = 100_000;

/// Returns a valid ball drawn uniformly from the action space; `None` if the scene of the obstacles has no room for
/// one.
pub fn uniform_ball(obstacles: &Obstacles, rng: &mut impl Rng) -> Option<Ball> {
    uniform_balls(obstacles, rng).next()
}

/// Returns the valid balls among `MAX_DRAWS` draws, uniform over the action space.
pub fn uniform_balls(obstacles: &Obstacles, rng: &mut impl Rng) -> impl Iterator<Item = Ball> {
    let actions = (0..MAX_DRAWS).map(|_| Action { x: rng.random(), y: rng.random(), r: rng.random() });
    actions.filter_map(|action| obstacles.place(action).ok())
}

/// Returns the action with Gaussian noise of this standard deviation on x, y and radius; the radius is clamped to
/// 0..=1.
pub fn perturbed(start: Action, deviation: f64, rng: &mut impl Rng) -> Action {
    let mut noisy = |value: f64| value + deviation * gaussian(rng);
    Action { x: noisy(start.x), y: noisy(start.y), r: noisy(start.r).clamp(0.0, 1.0) }
}

/// Draws from the standard normal distribution (Box and Muller 1958). Uses libm, so that wasm draws the same number.
pub fn gaussian(rng: &mut impl Rng) -> f64 {
    let (u, v): (f64, f64) = (1.0 - rng.random::<f64>(), rng.random());
    libm::sqrt(-2.0 * libm::log(u)) * libm::cos(std::f64::consts::TAU * v)
}
