//! The simulator: turns a scene and an optional ball into a complete rollout.
//!
//! `box2d` is PHYRE's engine, to the last bit. `simulation` builds the world of a scene, steps it, and decides when the
//! goal is reached. Results are bit-identical natively and in wasm: f32 throughout, libm for the trigonometry, and no
//! order that depends on a hash. This folder is the only user of rapier2d, which supplies vectors and bounding boxes,
//! the distances between bodies as drawn (`distance`, `closest_approach`, `first_contact`), and, natively only, its own
//! pipeline as a second engine behind the same interface (`rapier_world`, `engine`). Used by `session`, `search`,
//! `verification`, `web`, `commands` and the lab. Must not depend on tasks, images or nets.

use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::Rollout;
use crate::puzzle::sampled_paths::SampledPaths;
use crate::puzzle::scene::Scene;
use box2d::World;

pub use closest_approach::{ClosestApproach, closest_approach};
pub use contact_events::ContactEvent;
pub use engine::{Engine, UnknownEngine};
pub use first_contact::{Contact, first_contact};
pub use simulation::{Digest, Outcome, Simulation};

mod box2d;
mod closest_approach;
pub mod constants;
mod contact_events;
pub mod distance;
mod engine;
mod first_contact;
pub mod penetration;
#[cfg(not(target_arch = "wasm32"))]
mod rapier_world;
mod simulation;
pub mod units;

/// Version of the first engine's rollouts, raised whenever any of them changes. Stored in weights and collected data.
pub const VERSION: u32 = 4;

/// Simulates a scene, with or without a ball. Returns the complete rollout: the pose of every dynamic body at every
/// step.
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn simulate(scene: &Scene, ball: Option<Ball>) -> Result<Rollout, Invalid> {
    Ok(Simulation::<World>::new(scene, ball)?.rollout())
}

/// Simulates like `simulate`, but keeps no poses: for bulk work.
///
/// ```
/// use pathlight::puzzle::{action::Ball, task::Task};
/// use pathlight::simulator::outcome;
///
/// let task = Task::load("00007:008".parse()?)?;
/// assert!(!outcome(&task.scene, None)?.solved);
/// assert!(outcome(&task.scene, Some(Ball { x: 178.0, y: 218.0, r: 19.0 }))?.solved);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn outcome(scene: &Scene, ball: Option<Ball>) -> Result<Outcome, Invalid> {
    Ok(Simulation::<World>::new(scene, ball)?.run())
}

/// Simulates like `outcome`, and keeps the sampled paths of the green object and of the ball: for labels.
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn sampled_paths(scene: &Scene, ball: Ball) -> Result<(Outcome, SampledPaths), Invalid> {
    Ok(Simulation::<World>::new(scene, Some(ball))?.sampled_paths())
}

/// Simulates like `outcome`, and returns the `Digest` of the rollout.
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn digest(scene: &Scene, ball: Option<Ball>) -> Result<(Outcome, Digest), Invalid> {
    Ok(Simulation::<World>::new(scene, ball)?.digest())
}

/// Simulates like `simulate`, and returns the touches of bodies in the order of their beginnings.
///
/// Two bodies touch in a step if the engine has a touching contact of them, either at their positions before the step
/// or at a time of impact within it. `Rollout::touching` agrees for object and goal, unless both are balls: balls count
/// as touching there up to a gap of 0.1 px.
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn contacts(scene: &Scene, ball: Option<Ball>) -> Result<Vec<ContactEvent>, Invalid> {
    Ok(Simulation::<World>::new(scene, ball)?.contacts())
}
