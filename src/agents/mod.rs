//! The agents that propose balls: the model, which may learn from its attempts, and the random agent.
//!
//! The page, the command line and the lab all call these functions, so the same seed yields the same attempts. The
//! nets' results, and therefore the agents' proposals, are the same natively and in wasm, bit for bit
//! (`tests/proposals_golden.rs`). No agent calls the simulator. All balls are valid and in the order of the attempts.
//! `seed` belongs to one puzzle: `TaskId::seed`.

#[cfg(not(target_arch = "wasm32"))]
pub mod agent_name;
mod fitting_balls;
#[cfg(not(target_arch = "wasm32"))]
mod fixed_actions;
pub mod gaussian_process;
pub mod imagined_candidates;
pub mod memoized_model;
pub mod memory;
pub mod online;
pub mod placement;
pub mod ranking;
pub mod squared_exponential;

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use serde::Serialize;

use imagined_candidates::{CANDIDATES, imagined_candidates};
use memory::Recollection;
use online::{Candidate, OnlineAgent, Similarity};

use crate::benchmark::action_list::action_list;
#[cfg(not(target_arch = "wasm32"))]
use crate::nets::Dqn;
use crate::nets::PathNet;
use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::sampled_paths::SampledPaths;
use crate::puzzle::sampling::uniform_ball;
use crate::puzzle::scene::Scene;

/// An agent at work on one puzzle. It proposes balls one by one, and may learn from their outcomes.
pub trait Agent: Send {
    /// Returns the next ball; `None` if no more are left.
    fn propose(&mut self) -> Option<Proposal>;

    /// Reports the outcome of the attempt with the ball that was proposed last.
    fn observe(&mut self, observation: &Observation);
}

/// The outcome of an attempt, as reported to an agent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// Whether the attempt solved the task.
    pub solved: bool,
    /// The actual paths, if they were recorded.
    pub paths: Option<SampledPaths>,
}

/// A precomputed list acts as an agent that learns nothing.
impl Agent for std::vec::IntoIter<Proposal> {
    fn propose(&mut self) -> Option<Proposal> {
        self.next()
    }

    fn observe(&mut self, _: &Observation) {}
}

/// A valid ball that an agent proposes, and how it was found.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Proposal {
    /// The ball, px.
    pub ball: Ball,
    /// How it was found.
    pub origin: Origin,
}

impl Proposal {
    /// Returns the probability, 0..=1, that the ball solves, if the agent predicts one.
    pub fn chance(&self) -> Option<f64> {
        match self.origin {
            Origin::Map { .. } | Origin::Perturbed { .. } | Origin::Uniform => None,
            Origin::Success { probability } | Origin::Imagined { probability, .. } => Some(probability),
            #[cfg(not(target_arch = "wasm32"))]
            Origin::Dqn { probability } => Some(probability),
        }
    }
}

/// The origin of a proposal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[allow(missing_docs, reason = "the variants say what their fields are")]
pub enum Origin {
    /// A cell of the placement map, given by its centre in px, from which the ball was improved.
    Map { x: f64, y: f64 },
    /// The end of a random walk from an earlier proposal, given by its number from 1.
    Perturbed { number: usize },
    /// Uniform over the action space: from the random agent, or because no place on the placement map has room for a
    /// ball.
    Uniform,
    /// The success net's maps: the probability, 0..=1, that the ball solves, lowered by the proposals before it.
    Success { probability: f64 },
    /// The dynamics net: the probability, 0..=1, that the ball solves, first as imagined before any attempt (`prior`),
    /// then after the attempts so far. `lowered_by` is the number, from 1, of the attempt that lowered it most, if one
    /// did noticeably.
    Imagined { prior: f64, probability: f64, lowered_by: Option<usize> },
    /// DQN's fixed list: the probability, 0..=1, that the ball solves.
    #[cfg(not(target_arch = "wasm32"))]
    Dqn { probability: f64 },
}

/// Version of the proposals, like `simulator::VERSION` for the rollouts. Raise it whenever the same weights or the same
/// seed make an agent without a memory propose other balls or another order. Results record it, and those of other
/// versions are not comparable. `tests/proposals_golden.rs` fails when proposals change. A change in rounding needs no
/// new version if `pathlight-lab measure evaluate` finds the same solving attempts at all test tasks of fold 0, within
/// and cross.
pub const VERSION: u32 = 4;

/// Starts the model on a scene: the online agent, or, if the weights have no dynamics net, the list of up to `count`
/// proposals.
pub fn start(nets: &PathNet, scene: &Scene, seed: u64, count: usize) -> Box<dyn Agent> {
    start_from(imagined_candidates(nets, scene, count), nets, scene, seed, count)
}

/// Returns up to `count` proposals of the model, without learning from attempts. They come from the dynamics net, most
/// probable first; if the weights have none, from the success net; and without a success net, from the placement map.
pub fn propose(nets: &PathNet, scene: &Scene, seed: u64, count: usize) -> Vec<Proposal> {
    propose_from(imagined_candidates(nets, scene, CANDIDATES), nets, scene, seed, count)
}

/// `start` with candidates that are already imagined.
fn start_from(
    candidates: Option<Vec<Candidate>>,
    nets: &PathNet,
    scene: &Scene,
    seed: u64,
    count: usize,
) -> Box<dyn Agent> {
    match candidates {
        Some(candidates) => Box::new(OnlineAgent::new(candidates, Similarity::DEFAULT)),
        None => Box::new(propose_from(None, nets, scene, seed, count).into_iter()),
    }
}

/// `propose` with candidates that are already imagined.
fn propose_from(
    candidates: Option<Vec<Candidate>>,
    nets: &PathNet,
    scene: &Scene,
    seed: u64,
    count: usize,
) -> Vec<Proposal> {
    if let Some(candidates) = candidates {
        return imagined_candidates::proposals(candidates, nets, scene, count);
    }
    // A damaged success net may have logits that are NaN, which rank nothing.
    match from_success_net(nets, scene, count) {
        Some(ranked) if !ranked.is_empty() => ranked,
        _ => from_map(nets, scene, seed, count),
    }
}

/// Returns up to `count` proposals of the success net alone, or of the dynamics net's logits of the cells; `None` if
/// the weights have neither net.
pub fn from_success_net(nets: &PathNet, scene: &Scene, count: usize) -> Option<Vec<Proposal>> {
    Some(ranking::ranked(&nets.cell_logits(scene)?, scene, count))
}

/// Returns up to `count` proposals of the paper's four nets alone: the balls that the placement map suggests.
pub fn from_map(nets: &PathNet, scene: &Scene, seed: u64, count: usize) -> Vec<Proposal> {
    placement::proposals(&nets.imagine(scene).placement, scene, seed, count)
}

/// Returns the candidates of the paper's four nets with a memory: the balls that the placement map suggests, and balls
/// that solved similar scenes.
pub fn from_map_remembering(
    nets: &PathNet,
    scene: &Scene,
    seed: u64,
    count: usize,
    recollection: &Recollection,
) -> Vec<Candidate> {
    let list = from_map(nets, scene, seed, count.max(CANDIDATES));
    recollection.candidates(scene, list, placement::logit_of_rank)
}

/// Returns up to `count` proposals of DQN, the benchmark's baseline: the best actions of a fixed list.
#[cfg(not(target_arch = "wasm32"))]
pub fn from_dqn(dqn: &Dqn, scene: &Scene, count: usize) -> Vec<Proposal> {
    fixed_actions::ranked(dqn, scene, count)
}

/// Returns `count` balls drawn uniformly from the action space; none if the scene has no room for a ball.
pub fn random(scene: &Scene, seed: u64, count: usize) -> Vec<Proposal> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let obstacles = Obstacles::new(scene);
    let balls = std::iter::repeat_with(|| uniform_ball(&obstacles, &mut rng)).map_while(|ball| ball);
    balls.map(|ball| Proposal { ball, origin: Origin::Uniform }).take(count).collect()
}

/// Returns the first `count` balls of PHYRE's list of actions that are valid in the scene: the published agent RAND
/// (Bakhtin et al. 2019). Invalid actions are not attempts.
pub fn listed(scene: &Scene, count: usize) -> Vec<Proposal> {
    let obstacles = Obstacles::new(scene);
    let placed = action_list().filter_map(|action| obstacles.place(action).ok());
    placed.take(count).map(|ball| Proposal { ball, origin: Origin::Uniform }).collect()
}

/// Returns the probability of a logit. Uses libm, so that wasm computes the same value.
pub fn sigmoid(logit: f64) -> f64 {
    1.0 / (1.0 + libm::exp(-logit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

    #[test]
    fn listed_balls_are_the_valid_ones_of_one_list() {
        for id in ["00002:007", "00000:000"] {
            let scene = Task::load(id.parse().expect("an id")).expect("a task").scene;
            let balls: Vec<Ball> = listed(&scene, 100).into_iter().map(|proposal| proposal.ball).collect();
            let placed: Vec<Option<Ball>> = action_list().take(100).map(|action| action.place(&scene).ok()).collect();
            assert!(placed.contains(&None), "some are invalid");
            let valid: Vec<Ball> = placed.into_iter().flatten().collect();
            assert!(balls.len() == 100 && balls.starts_with(&valid));
        }
    }
}
