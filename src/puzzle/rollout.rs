//! The result of a simulation as plain data: whether it solved the task, and the pose of every dynamic body at every
//! step.
//!
//! Produced by `simulator`, played back by the page, drawn by `raster`, summarised by `session::ending`.

use serde::{Deserialize, Serialize};

/// Steps per second of simulated time (PHYRE).
pub const STEPS_PER_SECOND: usize = 60;

/// Consecutive steps for which the object must touch the goal: three seconds (PHYRE).
pub const GOAL_STEPS: usize = 3 * STEPS_PER_SECOND;

/// Maximum number of steps of a rollout (PHYRE).
pub const MAX_STEPS: usize = 1000;

/// PHYRE's status of an attempt.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// The object touched the goal for three seconds.
    Solved,
    /// The object did not, within `MAX_STEPS`.
    NotSolved,
    /// The action is invalid; nothing was simulated.
    Invalid,
}

/// Position and rotation of a body: x and y of its origin in px, angle in radians (not wrapped).
pub type Pose = [f32; 3];

/// One complete simulation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rollout {
    /// Whether the task was solved.
    pub solved: bool,
    /// Number of simulated steps: `MAX_STEPS`, or fewer if solved.
    pub steps: usize,
    /// The dynamic bodies, as indices into the scene's bodies; the action ball, if there is one, comes last
    /// and has the index after the last body.
    pub bodies: Vec<usize>,
    /// `(steps + 1) x bodies` poses, step by step; the first row is the start.
    pub poses: Vec<Pose>,
    /// For each of the `steps + 1` rows, whether the green object touches the goal.
    pub touching: Vec<bool>,
}

impl Rollout {
    /// Returns the status of the rollout.
    pub fn status(&self) -> Status {
        if self.solved { Status::Solved } else { Status::NotSolved }
    }

    /// Returns the poses after `step` steps, one for each of `bodies`.
    pub fn row(&self, step: usize) -> &[Pose] {
        let width = self.bodies.len();
        &self.poses[step * width..][..width]
    }

    /// Returns the pose of a body after `step` steps, by its index in the scene; `None` for a static body.
    pub fn pose(&self, step: usize, body: usize) -> Option<Pose> {
        let column = self.bodies.iter().position(|&dynamic| dynamic == body)?;
        Some(self.row(step)[column])
    }

    /// Returns the step from which nothing changes until the end: neither a pose nor the duration of the touch. For a
    /// rollout that ends with a touch, this is the last step.
    pub fn still_from(&self) -> usize {
        if self.touching[self.steps] {
            return self.steps;
        }
        let changes = |&step: &usize| self.touching[step - 1] || self.row(step - 1) != self.row(step);
        (1..=self.steps).rev().find(changes).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rollout of one body that is at these places.
    fn rollout(places: &[f32], touching: &[bool]) -> Rollout {
        let poses = places.iter().map(|&x| [x, 0.0, 0.0]).collect();
        Rollout { solved: false, steps: places.len() - 1, bodies: vec![0], poses, touching: touching.to_vec() }
    }

    #[test]
    fn it_is_still_after_the_last_change_of_a_pose_or_of_the_touch() {
        let none = [false; 5];
        assert_eq!(rollout(&[0.0, 1.0, 2.0, 2.0, 2.0], &none).still_from(), 2);
        assert_eq!(rollout(&[0.0; 5], &none).still_from(), 0);
        assert_eq!(rollout(&[0.0, 0.0, 0.0, 0.0, 1.0], &none).still_from(), 4);
        assert_eq!(rollout(&[0.0; 5], &[false, false, true, false, false]).still_from(), 3);
    }

    #[test]
    fn a_touch_that_lasts_to_the_end_is_a_change() {
        assert_eq!(rollout(&[0.0; 5], &[false, false, true, true, true]).still_from(), 4);
    }
}
