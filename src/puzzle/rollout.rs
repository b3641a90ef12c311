//! What came of a simulation, as plain data: how it ended, and the pose of every moving body at every step.
//!
//! Made by `simulator`; played back by the page, drawn by `raster`, compared by `game`.

use serde::{Deserialize, Serialize};

/// Steps that the goal must hold without a break: three seconds.
pub const GOAL_STEPS: usize = 180;

/// Steps in a second.
pub const STEPS_PER_SECOND: usize = 60;

/// The longest rollout.
pub const MAX_STEPS: usize = 1000;

/// How a rollout or an attempt ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    Solved,
    NotSolved,
    /// The ball could not be placed; nothing was simulated.
    Invalid,
}

/// How a body stands: x and y in px, angle in radians (not wrapped).
pub type Pose = [f32; 3];

/// One whole simulation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rollout {
    pub solved: bool,
    /// Steps simulated: at most 1000, and fewer if solved.
    pub steps: usize,
    /// The moving bodies, as indices into the scene's bodies; the action ball, if there is one, comes last
    /// and has the index after the last body.
    pub bodies: Vec<usize>,
    /// `(steps + 1) x bodies` poses, step by step; the first row is the start.
    pub poses: Vec<Pose>,
    /// For each of the `steps + 1` rows: does the green object touch the goal?
    pub touching: Vec<bool>,
}

impl Rollout {
    pub fn status(&self) -> Status {
        if self.solved { Status::Solved } else { Status::NotSolved }
    }

    /// The poses after `step` steps, one for each of `bodies`.
    pub fn row(&self, step: usize) -> &[Pose] {
        let width = self.bodies.len();
        &self.poses[step * width..][..width]
    }

    /// The pose of one of the scene's bodies after `step` steps, if that body moves.
    pub fn pose(&self, step: usize, body: usize) -> Option<Pose> {
        let column = self.bodies.iter().position(|&moving| moving == body)?;
        Some(self.row(step)[column])
    }
}
