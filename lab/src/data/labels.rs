//! Balls labelled with their outcome, solved or not, and with their paths: the training data of the success net, the
//! dynamics net and DQN.
//!
//! Half of the balls are sampled uniformly, the rest around known solutions of the same task or of other tasks of its
//! template (its siblings), so that near misses are included. Used by `data label`.

use base64::engine::general_purpose::STANDARD_NO_PAD;
use base64::{DecodeError, Engine};
use pathlight::puzzle::action::{Ball, Obstacles};
use pathlight::puzzle::sampled_paths::{SAMPLES, SampledPaths};
use pathlight::puzzle::sampling::{perturbed, uniform_ball};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::TaskId;
use pathlight::simulator::sampled_paths;
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::scene_id::SceneId;
use super::solutions::Solution;

/// Standard deviations of the noise added to a known solution, one chosen at random per ball, as a fraction of the
/// action space: 5 to 40 px in x and y.
const NOISE_LEVELS: [f64; 4] = [0.02, 0.04, 0.08, 0.16];

/// Labelled balls of one scene, grouped by outcome.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LabelledBalls {
    pub scene: SceneId,
    /// Balls that solve the scene, px.
    pub solved: Vec<Ball>,
    /// Balls that do not solve it, px.
    pub failed: Vec<Ball>,
    /// For each ball, solved ones first, the sibling around whose solution it was sampled, if any. A ball near a
    /// solution of a test task reveals that solution.
    pub siblings: Vec<Option<TaskId>>,
    /// For each ball, solved ones first, the sampled paths of the green object and of the ball.
    pub paths: LabelledPaths,
}

/// Bytes of the paths of one ball.
pub const PATHS_LEN: usize = 4 * SAMPLES;

/// The paths of several balls, `PATHS_LEN` bytes each: x and y at each sample, first of the object, then of the ball,
/// in whole px, 0..=255. In JSON, one base64 string.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct LabelledPaths(pub Vec<u8>);

impl LabelledPaths {
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

/// A ball to try, and the sibling around whose solution it was sampled, if any.
pub type Sampled = (Ball, Option<TaskId>);

/// A ball with its outcome and paths.
pub struct Tried {
    pub ball: Ball,
    sibling: Option<TaskId>,
    pub solved: bool,
    paths: SampledPaths,
}

/// Samples up to `count` valid balls of a scene. `own_solutions` solve it, `sibling_solutions` solve other tasks of its
/// template.
pub fn sample(
    (id, scene): (SceneId, &Scene),
    own_solutions: &[Ball],
    sibling_solutions: &[Solution],
    count: usize,
    rng: &mut Pcg64Mcg,
) -> Vec<Sampled> {
    let mut balls = Vec::with_capacity(count);
    let obstacles = Obstacles::new(scene);
    for index in 0..count {
        let own = |rng: &mut _| own_solutions.choose(rng).map(|&ball| (ball, None));
        let sibling = |rng: &mut _| sibling_solutions.choose(rng).map(|known| (known.ball, Some(known.task)));
        let known = match index % 4 {
            0 | 1 => None,
            2 => own(rng).or_else(|| sibling(rng)),
            _ => sibling(rng).or_else(|| own(rng)),
        };
        let near_known = known.and_then(|(known, task)| {
            let deviation = NOISE_LEVELS[rng.random_range(0..NOISE_LEVELS.len())];
            let ball = perturbed(known.action(), deviation, rng).place(scene).ok()?;
            Some((ball, task.filter(|&other| Some(other) != id.task())))
        });
        let Some(ball) = near_known.or_else(|| Some((uniform_ball(&obstacles, rng)?, None))) else { break };
        balls.push(ball);
    }
    balls
}

/// Simulates balls and drops invalid ones.
pub fn try_balls(scene: &Scene, balls: Vec<Sampled>) -> Vec<Tried> {
    let tried = balls.into_iter().filter_map(|(ball, sibling)| {
        let (outcome, paths) = sampled_paths(scene, ball).ok()?;
        Some(Tried { ball, sibling, solved: outcome.solved, paths })
    });
    tried.collect()
}

impl LabelledBalls {
    /// The number of balls.
    pub fn count(&self) -> usize {
        self.solved.len() + self.failed.len()
    }

    /// Simulates the balls again.
    ///
    /// # Errors
    /// If there is no such scene.
    pub fn tried_again(&self) -> anyhow::Result<LabelledBalls> {
        let balls = self.solved.iter().chain(&self.failed).copied().zip(self.siblings.iter().copied());
        Ok(LabelledBalls::new(self.scene, try_balls(&self.scene.scene()?, balls.collect())))
    }

    /// Groups the balls tried in a scene by outcome.
    pub fn new(scene: SceneId, tried: Vec<Tried>) -> LabelledBalls {
        let (solved, failed): (Vec<Tried>, Vec<Tried>) = tried.into_iter().partition(|ball| ball.solved);
        let mut paths = LabelledPaths::default();
        let mut siblings = Vec::new();
        for Tried { sibling, paths: of_ball, .. } in solved.iter().chain(&failed) {
            paths.push(of_ball);
            siblings.push(*sibling);
        }
        let balls = |tried: Vec<Tried>| tried.into_iter().map(|one| one.ball).collect();
        LabelledBalls { scene, solved: balls(solved), failed: balls(failed), siblings, paths }
    }
}
