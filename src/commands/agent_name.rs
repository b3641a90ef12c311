//! The agents by the names that the command line and the results give them.

use std::fmt;

use anyhow::ensure;
use clap::ValueEnum;
use pathlight::agents::imagined_candidates::imagined_candidates;
use pathlight::agents::online::{OnlineAgent, Similarity};
use pathlight::agents::{self, Agent};
use pathlight::nets::{Dqn, PathNet};
use pathlight::puzzle::scene::Scene;
use serde::{Deserialize, Serialize};

/// What proposes balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AgentName {
    /// The dynamics net, which imagines what balls lead to, and learns from its attempts
    Online,
    /// The same with balls compared by place and radius, not by the paths that they lead to; measured only if it is
    /// named
    OnlineByBalls,
    /// The dynamics net without learning from attempts
    Dynamics,
    /// The judge, which orders the balls
    Judge,
    /// The paper's four nets: balls from the placement map
    Paper,
    /// DQN, the benchmark's baseline, which ranks a fixed list of actions
    Dqn,
    /// Uniformly random balls
    Random,
}

/// The nets that were loaded.
#[derive(Clone, Copy)]
pub struct Loaded<'a> {
    /// Those of a model.
    pub nets: Option<&'a PathNet>,
    pub dqn: Option<&'a Dqn>,
}

impl AgentName {
    /// The agents of a model.
    pub const MODEL: [AgentName; 5] =
        [AgentName::Online, AgentName::OnlineByBalls, AgentName::Dynamics, AgentName::Judge, AgentName::Paper];

    /// Checks that the weights of a model have what this agent needs of them.
    ///
    /// # Errors
    /// Says what they lack.
    pub fn check(self, nets: &PathNet) -> anyhow::Result<()> {
        match self {
            AgentName::Judge => ensure!(
                nets.judge.is_some(),
                "the weights have no judge: train one with `pathlight train-judge`, or leave --agent judge out"
            ),
            AgentName::Online | AgentName::OnlineByBalls | AgentName::Dynamics => ensure!(
                nets.dynamics.is_some(),
                "the weights have no dynamics net: train one with `pathlight train-dynamics`, or leave --agent {self} out"
            ),
            AgentName::Dqn | AgentName::Paper | AgentName::Random => (),
        }
        Ok(())
    }

    /// Returns this agent at work on a scene, with up to `count` balls. `seed` is that of the puzzle; only the random
    /// agent goes without nets.
    pub fn start(self, loaded: Loaded, scene: &Scene, seed: u64, count: usize) -> Box<dyn Agent> {
        let nets = || loaded.nets.expect("the weights of a model are loaded first");
        // Damaged weights know no candidates; another agent must not be measured in the place of this one.
        let online =
            |similarity| OnlineAgent::new(imagined_candidates(nets(), scene, count).unwrap_or_default(), similarity);
        let proposals = match self {
            AgentName::Online => return Box::new(online(Similarity::DEFAULT)),
            AgentName::OnlineByBalls => return Box::new(online(Similarity::OF_BALLS)),
            AgentName::Dynamics => online(Similarity::DEFAULT).list(count),
            AgentName::Judge => agents::from_judge(nets(), scene, count).unwrap_or_default(),
            AgentName::Dqn => agents::from_dqn(loaded.dqn.expect("its weights are loaded first"), scene, count),
            AgentName::Paper => agents::from_map(nets(), scene, seed, count),
            AgentName::Random => agents::random(scene, seed, count),
        };
        Box::new(proposals.into_iter())
    }
}

impl fmt::Display for AgentName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.to_possible_value().expect("no agent is hidden").get_name())
    }
}
