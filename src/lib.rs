//! Pathlight plays PHYRE's 25 ball templates and shows the paths that four small nets imagine for them.
//!
//! A task is a scene and a goal: the green body has to touch its goal for three seconds. An action places one
//! red ball. The simulator turns both into a rollout; an agent proposes balls.
//!
//! ```
//! use pathlight::{action::Action, proposer, simulator::simulate, task::Task};
//!
//! let task = Task::load("00002:007".parse()?)?;
//! let ball = Action { x: 0.1, y: 0.9, r: 0.5 }.place(&task.scene)?;
//! let rollout = simulate(&task.scene, Some(ball))?;
//! println!("{}: {:?} after {} steps", task.goal, rollout.status(), rollout.steps);
//! let attempts = proposer::random(task.id, &task.scene, 0, 100);
//! assert!(attempts.iter().all(|ball| ball.check(&task.scene).is_ok()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! From the data outwards; each module uses only those above it:
//!
//! | modules | hold |
//! | --- | --- |
//! | `scene`, `action`, `rollout` | plain data: bodies, the action ball and when it is valid, poses over time |
//! | `layout`, `templates`, `task` | how the 2,500 tasks are laid out, and their ids |
//! | `simulator` | a scene and a ball in, a rollout out |
//! | `raster`, `overlap` | scenes and rollouts as 64 x 64 pictures, and how well two of them agree |
//! | `pathnet` | the four nets that imagine, and the one that judges |
//! | `placement`, `ranking` | balls from the placement map, and from the judge's maps |
//! | `proposer`, `folds`, `auccess` | who proposes balls, on which tasks, and how well |
//! | `solutions`, `samples`, `labels` | known solutions, the pictures that nets learn from, and balls by their outcome |
//! | `solve_map` | where a ball of one radius solves a scene, by simulation |
//! | `game`, `web` | one session on one puzzle, and the page's way in |

pub mod action;
pub mod auccess;
pub mod folds;
pub mod game;
pub mod labels;
pub mod layout;
pub mod overlap;
pub mod pathnet;
pub mod placement;
pub mod proposer;
pub mod ranking;
pub mod raster;
pub mod rollout;
pub mod samples;
pub mod scene;
pub mod simulator;
pub mod solutions;
pub mod solve_map;
pub mod task;
pub mod templates;
#[cfg(target_arch = "wasm32")]
pub mod web;
