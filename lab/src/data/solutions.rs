//! A random search for balls that solve tasks, several per task, by simulation; used by `data collect`.
//!
//! Uniform sampling alone would need millions of rollouts, because few balls solve a hard task. A ball that solves
//! one task of a template often solves others of it (its siblings), so the tasks of a template share what they
//! find. The search goes in rounds; within a round a task sees only what earlier rounds found, so the result
//! depends only on the seed and not on the number of cores.

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::sampling::{perturbed, random_ball};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::outcome;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

/// Balls that a task samples per round.
pub const SAMPLES_PER_ROUND: usize = 32;

/// Two solutions of a task differ by at least this much in x, y or radius, px.
pub const MIN_DISTANCE: f64 = 4.0;

/// Standard deviations of the noise added to a known solution, one chosen at random per sample, as a fraction of
/// the action space: 0.02 is 5 px in x and y, 0.08 is 20 px.
const NOISE_LEVELS: [f64; 3] = [0.0, 0.02, 0.08];

/// A ball that solves a task.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solution {
    pub task: TaskId,
    /// px
    pub ball: Ball,
}

/// The search for solutions of one task.
pub struct Search {
    pub task: TaskId,
    scene: Scene,
    /// Solutions found so far, in the order found.
    pub found: Vec<Ball>,
}

/// What one round of the search for one task found.
pub struct RoundResult {
    pub found: Vec<Ball>,
    /// Balls simulated.
    pub rollouts: usize,
}

impl Search {
    pub fn new(task: Task) -> Search {
        Search { task: task.id, scene: task.scene, found: Vec::new() }
    }

    /// Samples balls until `per_task` solutions are known in total or the samples of a round are used up. A third of
    /// the balls is uniform, a third lies around solutions of siblings, a third around solutions of this task.
    pub fn round(&self, sibling_solutions: &[Ball], per_task: usize, seed: u64, round: usize) -> RoundResult {
        let mut result = RoundResult { found: Vec::new(), rollouts: 0 };
        let mut rng = Pcg64Mcg::seed_from_u64(self.task.seed(seed).wrapping_add(round as u64));
        for sample in 0..SAMPLES_PER_ROUND {
            if self.found.len() + result.found.len() >= per_task {
                break;
            }
            let known = match sample % 3 {
                0 => None,
                1 => sibling_solutions.choose(&mut rng),
                _ => self.found.choose(&mut rng).or_else(|| sibling_solutions.choose(&mut rng)),
            };
            let ball = match known {
                None => match random_ball(&self.scene, &mut rng) {
                    Some(ball) => ball,
                    None => break,
                },
                Some(ball) => {
                    let deviation = NOISE_LEVELS[rng.random_range(0..NOISE_LEVELS.len())];
                    match perturbed(ball.action(), deviation, &mut rng).place(&self.scene) {
                        Ok(ball) => ball,
                        Err(_) => continue,
                    }
                }
            };
            if self.found.iter().chain(&result.found).any(|&other| is_duplicate(other, ball)) {
                continue;
            }
            result.rollouts += 1;
            if outcome(&self.scene, Some(ball)).is_ok_and(|outcome| outcome.solved) {
                result.found.push(ball);
            }
        }
        result
    }

    /// Tries given balls and keeps those that solve the task. Invalid balls do not.
    pub fn retry(&self, balls: impl Iterator<Item = Ball>) -> RoundResult {
        let mut rollouts = 0;
        let solves = |ball: &Ball| {
            rollouts += 1;
            outcome(&self.scene, Some(*ball)).is_ok_and(|outcome| outcome.solved)
        };
        RoundResult { found: balls.filter(solves).collect(), rollouts }
    }
}

fn is_duplicate(a: Ball, b: Ball) -> bool {
    [a.x - b.x, a.y - b.y, a.r - b.r].iter().all(|difference| difference.abs() < MIN_DISTANCE)
}
