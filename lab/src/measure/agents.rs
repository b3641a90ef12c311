//! How the agents are measured and drawn: one table, in the order of reports. `pathlight::agents::agent_name` has their
//! names and starts them.

use pathlight::agents::agent_name::AgentName;

/// How an agent is measured and drawn.
pub struct MeasuredAgent {
    pub agent: AgentName,
    /// Weights of a fold that the agent is measured with.
    pub weights: Weights,
    /// Whether the agent is measured only if it is named.
    pub on_request: bool,
    /// Colour and dashes in figures. The colours are those of Okabe and Ito, which colour-blind people can tell apart;
    /// neighbours differ in lightness too. The random agent is grey, so that the others stand out.
    pub style: (&'static str, &'static str),
}

/// Weights of a fold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weights {
    Paths,
    Success,
    Dynamics,
    Dqn,
    None,
}

/// All agents.
pub const AGENTS: [MeasuredAgent; AgentName::ALL.len()] = [
    MeasuredAgent {
        agent: AgentName::Online,
        weights: Weights::Dynamics,
        on_request: false,
        style: ("#0072b2", "none"),
    },
    MeasuredAgent {
        agent: AgentName::OnlineByBalls,
        weights: Weights::Dynamics,
        on_request: true,
        style: ("#8e5ab5", "2 3"),
    },
    MeasuredAgent {
        agent: AgentName::Dynamics,
        weights: Weights::Dynamics,
        on_request: false,
        style: ("#56b4e9", "7 3"),
    },
    MeasuredAgent {
        agent: AgentName::Success,
        weights: Weights::Success,
        on_request: false,
        style: ("#009e73", "none"),
    },
    MeasuredAgent { agent: AgentName::Dqn, weights: Weights::Dqn, on_request: false, style: ("#b8860b", "4 2") },
    MeasuredAgent {
        agent: AgentName::Paper,
        weights: Weights::Paths,
        on_request: false,
        style: ("#d55e00", "8 3 2 3"),
    },
    MeasuredAgent { agent: AgentName::Listed, weights: Weights::None, on_request: true, style: ("#4d4d4d", "1 3") },
    MeasuredAgent { agent: AgentName::Random, weights: Weights::None, on_request: false, style: ("#7a8089", "3 2") },
];

/// Returns the row of an agent.
pub fn row(agent: AgentName) -> &'static MeasuredAgent {
    AGENTS.iter().find(|row| row.agent == agent).expect("every agent has a row, as a test checks")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_agent_has_a_row_and_a_look_of_its_own() {
        for agent in AgentName::ALL {
            let MeasuredAgent { style, weights, .. } = row(agent);
            assert_eq!(AGENTS.iter().filter(|other| other.style.0 == style.0).count(), 1, "{agent}: its colour");
            assert_eq!(!matches!(weights, Weights::Dqn | Weights::None), agent.is_of_model(), "{agent}");
        }
    }
}
