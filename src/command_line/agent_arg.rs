//! Parses agent names on the command line; used by the lab's binary too.

use crate::agents::agent_name::AgentName;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Parses the name of an agent.
pub fn agent() -> impl TypedValueParser<Value = AgentName> {
    let names = AgentName::ALL.map(|agent| PossibleValue::new(agent.name()).help(agent.about()));
    PossibleValuesParser::new(names).try_map(|name| name.parse())
}
