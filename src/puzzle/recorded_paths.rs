//! The paths of the green object and of the action ball, as programs exchange them: their poses at every tenth step,
//! from the start.
//!
//! `simulate` writes them, and agents observe them. Agents compare `SampledPaths`; `sampled` returns those of a
//! recording.

use serde::{Deserialize, Serialize};

use super::rollout::{MAX_STEPS, Pose, Rollout};
use super::sampled_paths::{SAMPLED_STEPS, SampledPath, SampledPaths};
use super::scene::Scene;

/// Steps between two poses.
pub const STRIDE: usize = 10;

/// Poses after 0, 10, 20 … steps, px and radians. After the end of a recording, the bodies are taken to stay in place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordedPaths {
    /// The poses of the green object.
    pub object: Vec<Pose>,
    /// The poses of the action ball.
    pub ball: Vec<Pose>,
}

impl RecordedPaths {
    /// Maximum number of poses of a body.
    pub const MOST: usize = MAX_STEPS / STRIDE + 1;

    /// Returns the paths through a rollout of this scene; `None` if it has no action ball, or the green
    /// object is static.
    pub fn of(rollout: &Rollout, scene: &Scene) -> Option<RecordedPaths> {
        let path = |body| -> Option<Vec<Pose>> {
            (0..=rollout.steps).step_by(STRIDE).map(|step| rollout.pose(step, body)).collect()
        };
        Some(RecordedPaths { object: path(scene.body1)?, ball: path(scene.bodies.len())? })
    }

    /// Returns the positions at `SAMPLED_STEPS`, interpolated between poses; `None` if there are no poses, or if
    /// numbers are not valid positions.
    pub fn sampled(&self) -> Option<SampledPaths> {
        Some(SampledPaths { object: sampled(&self.object)?, ball: sampled(&self.ball)? })
    }
}

fn sampled(poses: &[Pose]) -> Option<SampledPath> {
    let last = poses.len().checked_sub(1)?;
    let path = SAMPLED_STEPS.map(|step| {
        let (before, after) = (poses[(step / STRIDE).min(last)], poses[step.div_ceil(STRIDE).min(last)]);
        let fraction = (step % STRIDE) as f32 / STRIDE as f32;
        [0, 1].map(|axis| before[axis] + fraction * (after[axis] - before[axis]))
    });
    path.iter().flatten().all(|coordinate| coordinate.is_finite()).then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_between_two_poses_are_interpolated_and_the_last_one_stays() {
        let moving: Vec<Pose> = (0..7).map(|index| [10.0 * index as f32, 100.0, 0.0]).collect();
        let paths = RecordedPaths { object: moving, ball: vec![[7.0, 8.0, 9.0]] };
        let sampled = paths.sampled().expect("poses");
        assert_eq!(sampled.object[..5].iter().map(|[x, _]| *x).collect::<Vec<_>>(), [15.0, 30.0, 45.0, 60.0, 60.0]);
        assert!(sampled.ball.iter().all(|&position| position == [7.0, 8.0]));
    }

    #[test]
    fn what_is_no_path_yields_none() {
        let poses = vec![[1.0, 2.0, 0.0]];
        for object in [vec![], vec![[f32::INFINITY, 0.0, 0.0]]] {
            assert_eq!(RecordedPaths { object, ball: poses.clone() }.sampled(), None);
        }
    }
}
