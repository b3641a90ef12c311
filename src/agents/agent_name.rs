//! The names of the agents on the command line and in the results. Native only.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::imagined_candidates::{candidates_of, imagined_candidates, remembered};
use super::memory::Recollection;
use super::online::{OnlineAgent, Similarity};
use super::{Agent, from_dqn, from_map, from_map_remembering, from_success_net, listed, random};
use crate::nets::{Dqn, PathNet};
use crate::puzzle::scene::Scene;

/// An agent, in the order of reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AgentName {
    /// Learns from its misses and imagines where balls lead (`OnlineAgent`).
    Online,
    /// Learns from its misses and compares balls only by place and radius.
    OnlineByBalls,
    /// The dynamics net's ranking; learns nothing.
    Dynamics,
    /// The success net's ranking; learns nothing.
    Success,
    /// The agent of Harter et al. (2020), based on the placement map.
    Paper,
    /// DQN's ranking, as in Bakhtin et al. (2019).
    Dqn,
    /// The published agent RAND: the first valid actions of PHYRE's list.
    Listed,
    /// Uniformly random valid balls.
    Random,
}

/// The loaded nets.
#[derive(Clone, Copy)]
pub struct Loaded<'a> {
    /// The nets of a model.
    pub nets: Option<&'a PathNet>,
    /// The weights of DQN.
    pub dqn: Option<&'a Dqn>,
}

/// What an agent needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// The paper's four nets, which every model has.
    FourNets,
    /// A model's success net.
    Success,
    /// A model's dynamics net.
    Dynamics,
    /// DQN, which has weights of its own.
    Dqn,
    /// No net.
    Nothing,
}

/// The net that an agent needs and the weights lack.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the weights have no {0} net: train one with `pathlight-lab train {0}`")]
pub struct LacksNet(&'static str);

/// An agent that cannot play with a memory.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("agent {0} cannot remember: use online, online-by-balls, paper or random")]
pub struct CannotRemember(AgentName);

/// A name that belongs to no agent.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown agent {0}: use {names}", names = AgentName::ALL.map(|name| name.to_string()).join(", "))]
pub struct UnknownAgent(String);

impl AgentName {
    /// All agents, in the order of reports.
    pub const ALL: [AgentName; 8] = [
        AgentName::Online,
        AgentName::OnlineByBalls,
        AgentName::Dynamics,
        AgentName::Success,
        AgentName::Paper,
        AgentName::Dqn,
        AgentName::Listed,
        AgentName::Random,
    ];

    /// Returns the agent's name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            AgentName::Online => "online",
            AgentName::OnlineByBalls => "online-by-balls",
            AgentName::Dynamics => "dynamics",
            AgentName::Success => "success",
            AgentName::Paper => "paper",
            AgentName::Dqn => "dqn",
            AgentName::Listed => "listed",
            AgentName::Random => "random",
        }
    }

    /// Returns a one-line description for the help text.
    pub fn about(self) -> &'static str {
        match self {
            AgentName::Online => "The dynamics net, which imagines what balls lead to, and learns from its attempts",
            AgentName::OnlineByBalls => {
                "The same with balls compared by place and radius, not by the paths that they lead to"
            }
            AgentName::Dynamics => "The dynamics net without learning from attempts",
            AgentName::Success => "The success net, which ranks the balls",
            AgentName::Paper => "The paper's four nets: balls from the placement map",
            AgentName::Dqn => "DQN, the benchmark's baseline, which ranks a fixed list of actions",
            AgentName::Listed => {
                "The benchmark's random agent as published, RAND: PHYRE's one list of random actions for all tasks"
            }
            AgentName::Random => "Uniformly random balls",
        }
    }

    /// Returns the agent that plays for a model unless another is asked for: the best one that it has the nets for.
    pub fn default_of(nets: &PathNet) -> AgentName {
        let agents = [AgentName::Online, AgentName::Success, AgentName::Paper];
        agents.into_iter().find(|agent| agent.check(nets).is_ok()).expect("every model has the four nets")
    }

    /// Returns what the agent needs.
    pub fn needs(self) -> Needs {
        match self {
            AgentName::Online | AgentName::OnlineByBalls | AgentName::Dynamics => Needs::Dynamics,
            AgentName::Success => Needs::Success,
            AgentName::Paper => Needs::FourNets,
            AgentName::Dqn => Needs::Dqn,
            AgentName::Listed | AgentName::Random => Needs::Nothing,
        }
    }

    /// Returns whether the agent needs a model's weights.
    pub fn is_of_model(self) -> bool {
        !matches!(self.needs(), Needs::Dqn | Needs::Nothing)
    }

    /// Checks that a model's weights have the net that this agent needs.
    ///
    /// # Errors
    ///
    /// If the net is missing; the error names it.
    pub fn check(self, nets: &PathNet) -> Result<(), LacksNet> {
        match self.needs() {
            Needs::Success if nets.success.is_none() => Err(LacksNet("success")),
            Needs::Dynamics if nets.dynamics.is_none() => Err(LacksNet("dynamics")),
            _ => Ok(()),
        }
    }

    /// Checks that this agent can play with a memory.
    ///
    /// # Errors
    /// If it cannot.
    pub fn check_remembers(self) -> Result<(), CannotRemember> {
        let remembers =
            matches!(self, AgentName::Online | AgentName::OnlineByBalls | AgentName::Paper | AgentName::Random);
        if remembers { Ok(()) } else { Err(CannotRemember(self)) }
    }

    /// Starts this agent on a scene, with what a memory says about its balls. The random agent then chooses among
    /// random balls.
    ///
    /// # Panics
    ///
    /// If the nets that it needs were not loaded, or the agent cannot remember.
    pub fn start_with(
        self,
        loaded: Loaded,
        scene: &Scene,
        seed: u64,
        count: usize,
        recollection: &Recollection,
    ) -> Box<dyn Agent> {
        if let Err(cannot) = self.check_remembers() {
            panic!("{cannot}");
        }
        let nets = || loaded.nets.expect("the weights of a model are loaded first");
        let remembered = |read| Some(remembered(candidates_of(&read, scene, count)?, &read, scene, recollection));
        let candidates = match self {
            AgentName::Random => recollection.random_candidates(scene, seed, count),
            AgentName::Paper => from_map_remembering(nets(), scene, seed, count, recollection),
            _ => nets().read(scene).and_then(remembered).unwrap_or_default(),
        };
        Box::new(OnlineAgent::new(candidates, self.similarity()))
    }

    /// Returns the similarity of balls that this agent uses when it learns from attempts.
    pub fn similarity(self) -> Similarity {
        match self {
            AgentName::Online | AgentName::Dynamics => Similarity::DEFAULT,
            _ => Similarity::OF_BALLS,
        }
    }

    /// Starts this agent on a scene, with up to `count` balls. `seed` is the puzzle's.
    ///
    /// # Panics
    ///
    /// If the nets that it needs were not loaded. `Listed` and `Random` need none.
    pub fn start(self, loaded: Loaded, scene: &Scene, seed: u64, count: usize) -> Box<dyn Agent> {
        let nets = || loaded.nets.expect("the weights of a model are loaded first");
        // Damaged weights yield no candidates. Do not measure another agent in place of this one.
        let online =
            || OnlineAgent::new(imagined_candidates(nets(), scene, count).unwrap_or_default(), self.similarity());
        let proposals = match self {
            AgentName::Online | AgentName::OnlineByBalls => return Box::new(online()),
            AgentName::Dynamics => online().list(count),
            AgentName::Success => from_success_net(nets(), scene, count).unwrap_or_default(),
            AgentName::Dqn => from_dqn(loaded.dqn.expect("its weights are loaded first"), scene, count),
            AgentName::Paper => from_map(nets(), scene, seed, count),
            AgentName::Listed => listed(scene, count),
            AgentName::Random => random(scene, seed, count),
        };
        Box::new(proposals.into_iter())
    }
}

impl fmt::Display for AgentName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for AgentName {
    type Err = UnknownAgent;

    fn from_str(text: &str) -> Result<AgentName, UnknownAgent> {
        let named = AgentName::ALL.into_iter().find(|agent| agent.name() == text);
        named.ok_or_else(|| UnknownAgent(text.to_string()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_and_command_line_name_the_agents_alike() {
        for (place, agent) in AgentName::ALL.into_iter().enumerate() {
            assert_eq!(agent as usize, place, "ALL is in the order of the variants");
            assert_eq!(serde_json::to_value(agent).expect("a name"), agent.name());
            assert_eq!(agent.name().parse(), Ok(agent));
        }
    }
}
