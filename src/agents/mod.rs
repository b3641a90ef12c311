//! The agents that propose balls by themselves: the model, and chance.
//!
//! The page, `propose` and `evaluate` ask here, so that with the same seed an agent makes the same attempts
//! everywhere. Neither calls the simulator. All balls are valid, in the order of the attempts; `run` is the seed
//! of the whole run, from which every task draws its own.

pub mod placement;
mod proposal;
pub mod ranking;

pub use proposal::{Origin, Proposal};

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use placement::proposals;
use ranking::ranked;

use crate::dataset::sampling::random_ball;
use crate::nets::PathNet;
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Scene;
use crate::puzzle::task::TaskId;

/// The model proposes what its judge thinks likely; without a judge, what its placement map shows.
pub fn model(nets: &PathNet, task: TaskId, scene: &Scene, run: u64, count: usize) -> Vec<Ball> {
    traced(nets, task, scene, run, count).into_iter().map(|proposal| proposal.ball).collect()
}

/// The same balls as `model`, each with where it comes from.
pub fn traced(nets: &PathNet, task: TaskId, scene: &Scene, run: u64, count: usize) -> Vec<Proposal> {
    let judged = nets.judged(scene).map(|logits| ranked(&logits, scene, count)).unwrap_or_default();
    // Damaged weights may make a judge whose logits are no numbers.
    if !judged.is_empty() {
        return judged;
    }
    proposals(&nets.imagine(scene).placement, scene, task.seed(run), count)
}

/// Chance draws uniformly from the action space.
pub fn random(task: TaskId, scene: &Scene, run: u64, count: usize) -> Vec<Ball> {
    let mut rng = Pcg64Mcg::seed_from_u64(task.seed(run));
    std::iter::repeat_with(|| random_ball(scene, &mut rng)).map_while(|ball| ball).take(count).collect()
}
