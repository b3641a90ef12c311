//! The paths of the green object and of the action ball through a rollout, sampled at a few steps. The dynamics net
//! learns to imagine them, and agents compare them.
//!
//! They contain only positions, of the bodies' origins. The steps are closer together at the start, where most of the
//! motion is.

use serde::{Deserialize, Serialize};

use super::rollout::Rollout;

/// The sampled steps. A rollout that ends earlier, because it solved, keeps its last positions.
pub const SAMPLED_STEPS: [usize; SAMPLES] =
    [15, 30, 45, 60, 80, 100, 120, 150, 180, 220, 260, 320, 400, 500, 700, 1000];

/// Number of positions of a path.
pub const SAMPLES: usize = 16;

/// x and y at each of `SAMPLED_STEPS`, px.
pub type SampledPath = [[f32; 2]; SAMPLES];

/// The paths that one ball leads to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SampledPaths {
    /// The path of the green object.
    pub object: SampledPath,
    /// The path of the action ball.
    pub ball: SampledPath,
}

impl SampledPaths {
    /// Returns the paths of the green object and of the action ball, by their indices in the scene, through a rollout;
    /// `None` if one of them is static.
    pub fn of(rollout: &Rollout, object: usize, ball: usize) -> Option<SampledPaths> {
        let mut paths = SampledPaths { object: [[0.0; 2]; SAMPLES], ball: [[0.0; 2]; SAMPLES] };
        for (sample, step) in SAMPLED_STEPS.into_iter().enumerate() {
            let step = step.min(rollout.steps);
            let position = |body| rollout.pose(step, body).map(|[x, y, _]| [x, y]);
            (paths.object[sample], paths.ball[sample]) = (position(object)?, position(ball)?);
        }
        Some(paths)
    }
}
