//! Pathlight plays PHYRE's 25 ball templates and shows what small neural nets imagine for them.
//!
//! A task is a scene and a goal: the green object must touch its goal for three seconds. An action places one red ball.
//! The simulator computes the rollout; an agent proposes balls.
//!
//! ```
//! use pathlight::puzzle::{action::Action, task::Task};
//! use pathlight::{agents, simulator::simulate};
//!
//! let task = Task::load("00002:007".parse()?)?;
//! let ball = Action { x: 0.1, y: 0.9, r: 0.5 }.place(&task.scene)?;
//! let rollout = simulate(&task.scene, Some(ball))?;
//! println!("{} Solved: {}, after {} steps", task.goal, rollout.solved, rollout.steps);
//! let attempts = agents::random(&task.scene, task.id.seed(0), 100);
//! assert!(attempts.iter().all(|attempt| attempt.ball.check(&task.scene).is_ok()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The modules, from the data outwards. Each uses only those above it (`tests/architecture` checks the order):
//!
//! | module | holds |
//! | --- | --- |
//! | `puzzle` | plain data: scenes, the action ball and when it is valid, rollouts, the 25 templates and their tasks |
//! | `colour` | the colours of roles and maps |
//! | `raster` | scenes and rollouts as 64 x 64 images, and how well two of them agree (soft IoU) |
//! | `simulator` | computes the rollout of a scene and a ball: PHYRE's Box2D, to the last bit |
//! | `benchmark` | PHYRE's folds and its metric, auccess |
//! | `nets` | the nets: the four, success net, dynamics net and DQN, and their weights; `training` is a feature |
//! | `agents` | what proposes balls: from imagined paths, from maps, at random |
//! | `session` | one session on one puzzle: what is played, an agent's turn, how a rollout ended |
//! | `verification` | attempts that anyone can simulate again |
//! | `search` | the solutions of a scene, the map of all solutions, luck |
//! | `web` | the wasm exports; wasm32 only |
//! | `command_line` | what the programs `pathlight` and `pathlight-lab` share; for these alone |
//!
//! `nets`, `agents` and everything that uses them need the feature `nets`, and `command_line` needs the feature `cli`.
//! Both are on by default; a crate that needs the library alone turns `cli` off.

#![warn(missing_docs, unreachable_pub)]

#[cfg(feature = "nets")]
pub mod agents;
pub mod benchmark;
pub mod colour;
#[cfg(all(feature = "cli", not(target_arch = "wasm32")))]
#[doc(hidden)]
pub mod command_line;
#[cfg(feature = "nets")]
pub mod nets;
pub mod puzzle;
pub mod raster;
pub mod search;
pub mod session;
pub mod simulator;
pub mod verification;
#[cfg(target_arch = "wasm32")]
pub mod web;
