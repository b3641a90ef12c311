//! The simulator: a port of Box2D 2.3's step, the engine of PHYRE, on rapier2d's geometry.
//!
//! A scene and perhaps a ball in, the complete rollout out. The only user of rapier2d, which supplies shapes, mass
//! properties, contact manifolds and distances; each file names the class or function of Box2D that it ports. Results
//! are bit-identical natively and in wasm: f32 throughout, libm for the trigonometry, and no order that depends on a
//! hash. Used by `session`, `search`, `verification`, `web`, `commands` and the lab. Must not depend on tasks, images
//! or nets.
//!
//! | file | ports |
//! | --- | --- |
//! | `constants` | b2Settings.h, and PHYRE's parameters |
//! | `body` | b2Body, b2Sweep |
//! | `fixture` | b2Fixture, b2FixtureProxy |
//! | `contact` | b2Contact, b2WorldManifold |
//! | `contact_solver`, `position_solver` | b2ContactSolver |
//! | `time_of_impact` | b2TimeOfImpact |
//! | `world` | b2World::Step, b2ContactManager |
//! | `island` | b2World::Solve, b2Island::Solve |
//! | `toi_solver` | b2World::SolveTOI, b2Island::SolveTOI |
//!
//! `rapier_world` is a second engine, rapier2d's own pipeline, behind the same interface (`simulation`, `engine`);
//! natively only.

use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::Rollout;
use crate::puzzle::sampled_paths::SampledPaths;
use crate::puzzle::scene::Scene;
use world::World;

pub use closest_approach::{ClosestApproach, closest_approach};
pub use engine::{Engine, UnknownEngine};
pub use first_contact::{Contact, first_contact};
pub use simulation::{Outcome, Simulation};

mod body;
mod closest_approach;
pub mod constants;
mod contact;
mod contact_solver;
pub mod distance;
mod engine;
mod first_contact;
mod fixture;
mod island;
pub mod penetration;
mod position_solver;
#[cfg(not(target_arch = "wasm32"))]
mod rapier_world;
mod scalar;
mod simulation;
mod time_of_impact;
mod toi_solver;
mod world;

/// Raised whenever any rollout of the first engine changes. Stored in weights and collected data.
pub const VERSION: u32 = 3;

/// Simulates a scene, with or without a ball. Returns the complete rollout: the pose of every dynamic body at every
/// step.
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn simulate(scene: &Scene, ball: Option<Ball>) -> Result<Rollout, Invalid> {
    Ok(Simulation::<World>::of(scene, ball)?.rollout())
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
    Ok(Simulation::<World>::of(scene, ball)?.run())
}

/// Simulates like `outcome`, and keeps the sampled paths of the green object and of the ball: for labels.
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn sampled_paths(scene: &Scene, ball: Ball) -> Result<(Outcome, SampledPaths), Invalid> {
    Ok(Simulation::<World>::of(scene, Some(ball))?.sampled_paths())
}
