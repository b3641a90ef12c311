//! The colours and dashes of agents in the figures.

use clap::ValueEnum;

use crate::commands::agent_name::AgentName;

/// Colour and dashes. The colours are those of Okabe and Ito, which colour-blind people can tell apart; neighbours
/// differ in lightness too.
pub type Style = (&'static str, &'static str);

const STYLES: [Style; 6] = [
    ("#0072b2", "none"),
    ("#8e5ab5", "2 3"),
    ("#56b4e9", "7 3"),
    ("#009e73", "none"),
    ("#d55e00", "8 3 2 3"),
    ("#b8860b", "4 2"),
];

/// The random agent is the ground that the others stand out from.
const RANDOM: Style = ("#7a8089", "3 2");

/// Returns the style of an agent: the same in all figures.
pub fn style(agent: AgentName) -> Style {
    if agent == AgentName::Random {
        return RANDOM;
    }
    let place = AgentName::value_variants().iter().position(|&one| one == agent).unwrap_or_default();
    STYLES[place % STYLES.len()]
}
