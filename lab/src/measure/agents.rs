//! How the agents are measured and drawn: one table, in the order of reports. `pathlight::agents::agent_name` has their
//! names and starts them.

use pathlight::agents::agent_name::AgentName;

/// How an agent is measured and drawn.
pub struct MeasuredAgent {
    pub agent: AgentName,
    /// Whether the agent is measured only if it is named.
    pub on_request: bool,
    /// Colour and dashes in figures. The colours are those of Okabe and Ito, which colour-blind people can tell apart;
    /// neighbours differ in lightness too. The random agent is grey, so that the others stand out.
    pub style: (&'static str, &'static str),
}

/// All agents.
pub const AGENTS: [MeasuredAgent; AgentName::ALL.len()] = [
    MeasuredAgent { agent: AgentName::Online, on_request: false, style: ("#0072b2", "none") },
    MeasuredAgent { agent: AgentName::OnlineByBalls, on_request: true, style: ("#8e5ab5", "2 3") },
    MeasuredAgent { agent: AgentName::Dynamics, on_request: false, style: ("#56b4e9", "7 3") },
    MeasuredAgent { agent: AgentName::Success, on_request: false, style: ("#009e73", "none") },
    MeasuredAgent { agent: AgentName::Dqn, on_request: false, style: ("#b8860b", "4 2") },
    MeasuredAgent { agent: AgentName::Paper, on_request: false, style: ("#d55e00", "8 3 2 3") },
    MeasuredAgent { agent: AgentName::Listed, on_request: true, style: ("#4d4d4d", "1 3") },
    MeasuredAgent { agent: AgentName::Random, on_request: false, style: ("#7a8089", "3 2") },
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
            let style = row(agent).style;
            assert_eq!(AGENTS.iter().filter(|other| other.style.0 == style.0).count(), 1, "{agent}: its colour");
        }
    }
}
