//! Balls labelled with their outcome, solved or not, and the paths they led to: the training data of the judge and of the dynamics net.
//!
//! Half of the balls are sampled uniformly; the rest are sampled around known solutions of this task or of others of
//! its template (its siblings), so that near misses are among them. Used by `pathlight label`.

use base64::engine::general_purpose::STANDARD_NO_PAD;
use base64::{DecodeError, Engine};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::sampling::{perturbed, random_ball};
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::{SAMPLES, SampledPaths};
use crate::puzzle::task::{Task, TaskId};
use crate::simulator::sampled_paths;

/// Standard deviations of the noise added to a known solution, one chosen at random per ball, as a fraction of the
/// action space: 5 to 40 px in x and y.
const NOISE_LEVELS: [f64; 4] = [0.02, 0.04, 0.08, 0.16];

/// Some balls of one task, by their outcome.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LabelledBalls {
    pub task: TaskId,
    /// The number of the variant of the task's scene in which the balls were tried; absent if it was the scene itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub variant: Option<u32>,
    /// Balls that solve the task, px.
    pub solved: Vec<Ball>,
    /// Balls that do not, px.
    pub failed: Vec<Ball>,
    /// The sampled paths of the green object and of the ball for each ball, the solved ones first. Absent from older files.
    #[serde(default, skip_serializing_if = "LabelledPaths::is_empty")]
    pub paths: LabelledPaths,
}

/// Bytes of the paths of one ball.
pub const PATHS_LEN: usize = 4 * SAMPLES;

/// The paths of several balls, `PATHS_LEN` bytes each: x and y at each sample, first of the object, then of the ball, in
/// whole px, 0..=255. In JSON one string in base64.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct LabelledPaths(pub Vec<u8>);

impl LabelledPaths {
    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn push(&mut self, paths: &SampledPaths) {
        let positions = paths.object.iter().chain(&paths.ball).flatten();
        self.0.extend(positions.map(|coordinate| coordinate.round().clamp(0.0, 255.0) as u8));
    }
}

impl From<LabelledPaths> for String {
    fn from(paths: LabelledPaths) -> String {
        STANDARD_NO_PAD.encode(paths.0)
    }
}

impl TryFrom<String> for LabelledPaths {
    type Error = DecodeError;

    fn try_from(text: String) -> Result<LabelledPaths, DecodeError> {
        STANDARD_NO_PAD.decode(text).map(LabelledPaths)
    }
}

impl LabelledBalls {
    /// Samples and simulates `count` valid balls. `own_solutions` solve this task, `sibling_solutions` solve tasks of
    /// its template; each `round` samples other balls.
    pub fn sample(
        task: &Task,
        own_solutions: &[Ball],
        sibling_solutions: &[Ball],
        count: usize,
        seed: u64,
        round: usize,
    ) -> LabelledBalls {
        let mut balls = Vec::with_capacity(count);
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(seed).wrapping_add(round as u64));
        for index in 0..count {
            let known = match index % 4 {
                0 | 1 => None,
                2 => own_solutions.choose(&mut rng).or_else(|| sibling_solutions.choose(&mut rng)),
                _ => sibling_solutions.choose(&mut rng),
            };
            let perturbed_ball = known.and_then(|ball| {
                let deviation = NOISE_LEVELS[rng.random_range(0..NOISE_LEVELS.len())];
                perturbed(ball.action(), deviation, &mut rng).place(&task.scene).ok()
            });
            let Some(ball) = perturbed_ball.or_else(|| random_ball(&task.scene, &mut rng)) else { break };
            balls.push(ball);
        }
        LabelledBalls::simulate(task, balls)
    }

    /// Simulates valid balls; invalid ones are left out.
    pub fn simulate(task: &Task, balls: Vec<Ball>) -> LabelledBalls {
        let simulated = balls.into_iter().filter_map(|ball| Some((ball, sampled_paths(&task.scene, ball).ok()?)));
        let (solved, failed): (Vec<_>, Vec<_>) = simulated.partition(|(_, (outcome, _))| outcome.solved);
        let mut paths = LabelledPaths::default();
        for (_, (_, of_ball)) in solved.iter().chain(&failed) {
            paths.push(of_ball);
        }
        let balls = |labelled: Vec<(Ball, _)>| labelled.into_iter().map(|(ball, _)| ball).collect();
        LabelledBalls { task: task.id, variant: None, solved: balls(solved), failed: balls(failed), paths }
    }
}
