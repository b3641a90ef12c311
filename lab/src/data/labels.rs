//! Balls labelled with their outcome, solved or not, and the paths they led to: the training data of the success net,
//! the dynamics net and DQN.
//!
//! Half of the balls are sampled uniformly; the rest are sampled around known solutions of this task or of others of
//! its template (its siblings), so that near misses are among them. Used by `data label`.

use base64::engine::general_purpose::STANDARD_NO_PAD;
use base64::{DecodeError, Engine};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::sampled_paths::{SAMPLES, SampledPaths};
use pathlight::puzzle::sampling::{perturbed, random_ball};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::sampled_paths;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::solutions::Solution;

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
    /// For each ball, the solved ones first, the other task of the template around whose solution it was sampled, if it
    /// was: a ball near a solution of a test task tells of it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub siblings: Vec<Option<TaskId>>,
    /// The sampled paths of the green object and of the ball for each ball, the solved ones first. Absent from older
    /// files.
    #[serde(default, skip_serializing_if = "LabelledPaths::is_empty")]
    pub paths: LabelledPaths,
}

/// Bytes of the paths of one ball.
pub const PATHS_LEN: usize = 4 * SAMPLES;

/// The paths of several balls, `PATHS_LEN` bytes each: x and y at each sample, first of the object, then of the ball,
/// in whole px, 0..=255. In JSON one string in base64.
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
        sibling_solutions: &[Solution],
        count: usize,
        seed: u64,
        round: usize,
    ) -> LabelledBalls {
        let mut balls = Vec::with_capacity(count);
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(seed).wrapping_add(round as u64));
        for index in 0..count {
            let own = |rng: &mut _| own_solutions.choose(rng).map(|&ball| Solution { task: task.id, ball });
            let sibling = |rng: &mut _| sibling_solutions.choose(rng).copied();
            let known = match index % 4 {
                0 | 1 => None,
                2 => own(&mut rng).or_else(|| sibling(&mut rng)),
                _ => sibling(&mut rng),
            };
            let near_known = known.and_then(|known| {
                let deviation = NOISE_LEVELS[rng.random_range(0..NOISE_LEVELS.len())];
                let ball = perturbed(known.ball.action(), deviation, &mut rng).place(&task.scene).ok()?;
                Some((ball, Some(known.task).filter(|&other| other != task.id)))
            });
            let Some(ball) = near_known.or_else(|| Some((random_ball(&task.scene, &mut rng)?, None))) else { break };
            balls.push(ball);
        }
        LabelledBalls::label(task, balls)
    }

    /// Simulates valid balls; invalid ones are left out.
    pub fn simulate(task: &Task, balls: Vec<Ball>) -> LabelledBalls {
        LabelledBalls::label(task, balls.into_iter().map(|ball| (ball, None)).collect())
    }

    /// Simulates balls with the sibling that each was sampled around.
    fn label(task: &Task, balls: Vec<(Ball, Option<TaskId>)>) -> LabelledBalls {
        let simulated = balls.into_iter().filter_map(|one| Some((one, sampled_paths(&task.scene, one.0).ok()?)));
        let (solved, failed): (Vec<_>, Vec<_>) = simulated.partition(|(_, (outcome, _))| outcome.solved);
        let mut paths = LabelledPaths::default();
        let mut siblings = Vec::new();
        for ((_, sibling), (_, of_ball)) in solved.iter().chain(&failed) {
            paths.push(of_ball);
            siblings.push(*sibling);
        }
        let balls = |labelled: Vec<((Ball, _), _)>| labelled.into_iter().map(|((ball, _), _)| ball).collect();
        LabelledBalls { task: task.id, variant: None, solved: balls(solved), failed: balls(failed), siblings, paths }
    }
}
