//! Auccess of each agent on each template.

use pathlight::agents::agent_name::AgentName;
use pathlight::puzzle::templates::TEMPLATES;
use svg::node::element::Definitions;

use super::bar_table::{self, Column, Columns, Scale};
use super::measured::Group;
use super::picture::Figure;
use crate::measure::agents::row;

/// Draws the figure.
pub fn draw(groups: &[Group]) -> Figure {
    let columns = |group: &Group| -> Vec<Column> {
        let column = |agent: &super::measured::Measured| Column {
            headings: headings(agent.agent),
            colour: row(agent.agent).style.0,
            values: (0..TEMPLATES.len()).map(Some).chain([None]).map(|template| agent.auccess(template)).collect(),
            marks: Vec::new(),
        };
        group.agents.iter().map(column).collect()
    };
    let groups: Vec<Columns> = groups
        .iter()
        .map(|group| Columns { headings: [group.setup.to_string(), group.of.clone()], columns: columns(group) })
        .collect();
    let scale = Scale { most: 100.0, decimals: 0 };
    let (content, size) = bar_table::draw(&groups, &scale);
    Figure {
        name: "auccess-by-template",
        title: "Auccess by template",
        caption:
            "Auccess of each agent on the test tasks of each template, 0 to 100, mean over the folds that test it. In \
                  the setup cross a fold tests five templates."
                .to_string(),
        numbers: bar_table::sentences(&groups, &scale),
        size,
        definitions: Definitions::new(),
        content,
    }
}

/// The name of an agent on two lines, because a column is narrow.
fn headings(agent: AgentName) -> [String; 2] {
    let name = agent.to_string();
    let (above, below) = name.split_once('-').unwrap_or(("", &name));
    [above.to_string(), below.replace('-', " ")]
}
