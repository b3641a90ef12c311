//! Who proposes balls: the model, or chance. The page, `propose` and `evaluate` ask here, so that an agent
//! with the same seed makes the same attempts everywhere. No agent calls the simulator.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::action::Ball;
use crate::pathnet::PathNet;
use crate::placement::{proposals, random_balls};
use crate::scene::Scene;
use crate::task::TaskId;

pub enum Agent {
    /// Imagines, then proposes what its placement map shows.
    Model(Box<PathNet>),
    /// Draws valid balls uniformly.
    Random,
}

impl Agent {
    /// The balls to try at a task, in order; all valid. `run` is the seed of the whole run.
    pub fn attempts(&self, task: TaskId, scene: &Scene, run: u64, count: usize) -> Vec<Ball> {
        match self {
            Agent::Model(nets) => proposals(&nets.imagine(scene).placement, scene, task.seed(run), count),
            Agent::Random => random_balls(scene, &mut Pcg64Mcg::seed_from_u64(task.seed(run)), count),
        }
    }
}
