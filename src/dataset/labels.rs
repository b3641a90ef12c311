//! Balls labelled with their outcome, solved or not: the training data of the judge.
//!
//! Half of the balls are sampled uniformly; the rest are sampled around known solutions of this task or of others of
//! its template (its siblings), so that near misses are among them. Used by `pathlight label`.

use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::sampling::{perturbed, random_ball};
use crate::puzzle::action::Ball;
use crate::puzzle::task::{Task, TaskId};
use crate::simulator::outcome;

/// Standard deviations of the noise added to a known solution, one chosen at random per ball, as a fraction of the
/// action space: 5 to 40 px in x and y.
const NOISE_LEVELS: [f64; 4] = [0.02, 0.04, 0.08, 0.16];

/// Some balls of one task, by their outcome.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LabelledBalls {
    pub task: TaskId,
    /// Balls that solve the task, px.
    pub solved: Vec<Ball>,
    /// Balls that do not, px.
    pub failed: Vec<Ball>,
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
        let mut labelled = LabelledBalls { task: task.id, solved: Vec::new(), failed: Vec::new() };
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
            let solved = outcome(&task.scene, Some(ball)).is_ok_and(|outcome| outcome.solved);
            if solved { &mut labelled.solved } else { &mut labelled.failed }.push(ball);
        }
        labelled
    }
}
