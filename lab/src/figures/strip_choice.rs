//! Which tasks a figure of strips shows.

use anyhow::Context;
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess};
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;

use crate::measure::report::Report;

/// A task counts as solved late if this attempt or a later one solved it.
const LATE: usize = 10;

/// How many of the weakest templates are shown.
const WEAKEST: usize = 3;

/// The rule that chooses the tasks of each setup.
#[derive(Clone, Copy)]
pub enum Choice {
    /// One solved at once, one solved late, one not solved.
    Outcomes,
    /// One of each of the templates on which the agent has the lowest auccess.
    Weakest,
}

/// A task to show.
pub struct Chosen {
    pub task: TaskId,
    /// The attempt that solved it, from 1.
    pub first: Option<usize>,
    /// What is said below its name.
    pub note: String,
}

impl Choice {
    /// The name of the figure's file, without its ending.
    pub fn name(self) -> &'static str {
        match self {
            Choice::Outcomes => "strips",
            Choice::Weakest => "weakest",
        }
    }

    pub fn title(self) -> &'static str {
        match self {
            Choice::Outcomes => "What the nets imagine, and what happens",
            Choice::Weakest => "The weakest templates: what the nets imagine, and what happens",
        }
    }

    /// The rule, in a sentence.
    pub fn rule(self) -> String {
        match self {
            Choice::Outcomes => format!(
                "Of each setup, in the order of the test tasks of fold 0, the first that the agent solved at once, the \
                 first that it solved at attempt {LATE} or later, and the first that it did not solve in {MAX_ATTEMPTS}."
            ),
            Choice::Weakest => format!(
                "Of each setup, the {WEAKEST} templates on which the agent has the lowest auccess, weakest first; of \
                 each the first test task of fold 0 that it did not solve at once."
            ),
        }
    }

    /// Returns the tasks that the rule chooses of a setup; those of them that there are.
    ///
    /// # Errors
    /// If the report holds no agents.
    pub fn tasks(self, report: &Report) -> anyhow::Result<Vec<Chosen>> {
        let agent = report
            .agents
            .first()
            .context("the evaluation holds no agents: run `pathlight-lab measure evaluate --json` again")?;
        let first_of = |rule: &dyn Fn(TaskId, Option<usize>) -> bool| {
            agent.first_solved.iter().find(|&&(task, first)| rule(task, first)).copied()
        };
        Ok(match self {
            Choice::Outcomes => {
                type Rule = fn(Option<usize>) -> bool;
                let rules: [(Rule, &str); 3] = [
                    (|first| first == Some(1), "solved at once"),
                    (|first| first.is_some_and(|first| first >= LATE), "solved late"),
                    (|first| first.is_none(), "not solved"),
                ];
                let chosen = |(rule, outcome): (Rule, &str)| {
                    let (task, first) = first_of(&|_, first| rule(first))?;
                    Some(Chosen { task, first, note: outcome.to_string() })
                };
                rules.into_iter().filter_map(chosen).collect()
            }
            Choice::Weakest => {
                let chosen = |(template, score): (usize, f64)| {
                    let (task, first) = first_of(&|task, first| task.template == template && first != Some(1))?;
                    Some(Chosen { task, first, note: format!("template's auccess {score:.0}") })
                };
                weakest(report, agent.agent).into_iter().take(WEAKEST).filter_map(chosen).collect()
            }
        })
    }
}

/// The templates of a report and an agent's auccess on each, the lowest first.
fn weakest(report: &Report, agent: AgentName) -> Vec<(usize, f64)> {
    let tested = TEMPLATES.iter().filter_map(|template| {
        let firsts = report.first_solved(agent, Some(template.number));
        (!firsts.is_empty()).then(|| (template.number, auccess(&firsts)))
    });
    let mut scores: Vec<(usize, f64)> = tested.collect();
    scores.sort_by(|one, other| one.1.total_cmp(&other.1));
    scores
}
