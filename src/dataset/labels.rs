//! Balls with their outcome, solved or not: what a net learns from that judges balls.
//!
//! Half of the balls are drawn uniformly; the others lie about balls that solve the task or a sister, so that
//! near misses are among them. Used by `pathlight label`.

use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::sampling::{perturbed, random_ball};
use crate::puzzle::action::Ball;
use crate::puzzle::task::{Task, TaskId};
use crate::simulator::outcome;

/// Standard deviation of the noise on a ball that solves, as a share of the action space: 5 to 40 px.
const NOISE: [f64; 4] = [0.02, 0.04, 0.08, 0.16];

/// Some balls of a task, by their outcome.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Labels {
    pub task: TaskId,
    /// Balls that solve the task, px.
    pub solved: Vec<Ball>,
    /// Balls that do not, px.
    pub failed: Vec<Ball>,
}

impl Labels {
    /// Tries so many valid balls. `own` solve the task, `sisters` solve tasks of the template; every `round`
    /// draws others.
    pub fn draw(task: &Task, own: &[Ball], sisters: &[Ball], balls: usize, seed: u64, round: usize) -> Labels {
        let mut labels = Labels { task: task.id, solved: Vec::new(), failed: Vec::new() };
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(seed).wrapping_add(round as u64));
        for turn in 0..balls {
            let known = match turn % 4 {
                0 | 1 => None,
                2 => own.choose(&mut rng).or_else(|| sisters.choose(&mut rng)),
                _ => sisters.choose(&mut rng),
            };
            let near = known.and_then(|ball| {
                let deviation = NOISE[rng.random_range(0..NOISE.len())];
                perturbed(ball.action(), deviation, &mut rng).place(&task.scene).ok()
            });
            let Some(ball) = near.or_else(|| random_ball(&task.scene, &mut rng)) else { break };
            let solved = outcome(&task.scene, Some(ball)).is_ok_and(|outcome| outcome.solved);
            if solved { &mut labels.solved } else { &mut labels.failed }.push(ball);
        }
        labels
    }
}
