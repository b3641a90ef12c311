//! Finding balls that solve tasks, many for each, by simulation.
//!
//! Uniform draws alone would need millions of rollouts: few balls solve a hard task. But what solves one task
//! of a template often solves its sisters, so tasks of a template share what they find. Work goes in rounds;
//! within a round a task sees only what earlier rounds found, so the result hangs on the seed alone and not on
//! the number of cores. Used by `pathlight collect`.

use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::sampling::{perturbed, random_ball};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Scene;
use crate::puzzle::task::{Task, TaskId};
use crate::simulator::outcome;

/// Balls that a task tries in a round.
pub const DRAWS: usize = 32;

/// Two solutions of a task differ by at least this in x, y or radius, px.
pub const SPREAD: f64 = 4.0;

/// Standard deviation of the noise on a ball that has solved this task or a sister, as a share of the action
/// space: from a few px to a good part of the scene.
const NOISE: [f64; 3] = [0.0, 0.02, 0.08];

/// A ball that solves a task.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solution {
    pub task: TaskId,
    /// px
    pub ball: Ball,
}

/// The search for solutions of one task.
pub struct Hunt {
    pub task: TaskId,
    scene: Scene,
    /// Found so far, in the order found.
    pub found: Vec<Ball>,
}

/// What one task did in one round.
pub struct Catch {
    pub found: Vec<Ball>,
    pub rollouts: usize,
}

impl Hunt {
    pub fn new(task: Task) -> Hunt {
        Hunt { task: task.id, scene: task.scene, found: Vec::new() }
    }

    /// One round: tries balls until `wanted` are known in all or the draws are used up. A third of the balls is
    /// uniform, a third comes from the `sisters`, a third from what is known of this task itself.
    pub fn round(&self, sisters: &[Ball], wanted: usize, seed: u64, round: usize) -> Catch {
        let mut catch = Catch { found: Vec::new(), rollouts: 0 };
        let mut rng = Pcg64Mcg::seed_from_u64(self.task.seed(seed).wrapping_add(round as u64));
        for draw in 0..DRAWS {
            if self.found.len() + catch.found.len() >= wanted {
                break;
            }
            let known = match draw % 3 {
                0 => None,
                1 => sisters.choose(&mut rng),
                _ => self.found.choose(&mut rng).or_else(|| sisters.choose(&mut rng)),
            };
            let ball = match known {
                None => match random_ball(&self.scene, &mut rng) {
                    Some(ball) => ball,
                    None => break,
                },
                Some(ball) => {
                    let deviation = NOISE[rng.random_range(0..NOISE.len())];
                    match perturbed(ball.action(), deviation, &mut rng).place(&self.scene) {
                        Ok(ball) => ball,
                        Err(_) => continue,
                    }
                }
            };
            if self.found.iter().chain(&catch.found).any(|other| near(*other, ball)) {
                continue;
            }
            catch.rollouts += 1;
            if outcome(&self.scene, Some(ball)).is_ok_and(|outcome| outcome.solved) {
                catch.found.push(ball);
            }
        }
        catch
    }

    /// Which of these balls solve the task, still or again; invalid ones do not.
    pub fn retry(&self, balls: impl Iterator<Item = Ball>) -> Catch {
        let mut rollouts = 0;
        let solves = |ball: &Ball| {
            rollouts += 1;
            outcome(&self.scene, Some(*ball)).is_ok_and(|outcome| outcome.solved)
        };
        Catch { found: balls.filter(solves).collect(), rollouts }
    }
}

fn near(a: Ball, b: Ball) -> bool {
    [a.x - b.x, a.y - b.y, a.r - b.r].iter().all(|apart| apart.abs() < SPREAD)
}
