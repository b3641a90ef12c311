//! The agents by the names that the command line and the results give them.

use std::fmt;

use anyhow::ensure;
use clap::ValueEnum;
use pathlight::agents::{self, Agent};
use pathlight::nets::PathNet;
use pathlight::puzzle::scene::Scene;
use serde::{Deserialize, Serialize};

/// What proposes balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AgentName {
    /// The model with its judge, which orders the balls
    Judge,
    /// The model without the judge: balls from its placement map, as in the paper
    Paper,
    /// Uniformly random balls
    Random,
}

impl AgentName {
    /// The agents that need nets.
    pub const MODEL: [AgentName; 2] = [AgentName::Judge, AgentName::Paper];

    /// Checks that the weights have what this agent needs.
    ///
    /// # Errors
    /// Says what they lack.
    pub fn check(self, nets: &PathNet) -> anyhow::Result<()> {
        ensure!(
            self != AgentName::Judge || nets.judge.is_some(),
            "the weights have no judge: train one with `pathlight train-judge`, or leave --agent judge out"
        );
        Ok(())
    }

    /// Returns this agent at work on a scene, with up to `count` balls. `seed` is that of the puzzle; only the random agent
    /// goes without nets.
    pub fn start(self, nets: Option<&PathNet>, scene: &Scene, seed: u64, count: usize) -> Box<dyn Agent> {
        let nets = || nets.expect("the weights of a model are loaded first");
        let proposals = match self {
            AgentName::Judge => agents::propose(nets(), scene, seed, count),
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
