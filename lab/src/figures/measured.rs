//! What was measured, as the figures show it: the first solving attempts of agents, in groups that may be compared.

use std::path::Path;

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::{auccess, solved_within};
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::puzzle::task::TaskId;

use crate::measure::report::Report;
use crate::measure::shipped::Shipped;
use crate::reproduce::compared::main_results;

/// The fold of the models that the page has.
const SHIPPED_FOLD: u8 = 0;

/// Agents that played the same tasks.
pub struct Group {
    pub setup: Setup,
    /// Which folds and models.
    pub of: String,
    pub agents: Vec<Measured>,
}

/// An agent's results.
pub struct Measured {
    pub agent: AgentName,
    /// For each fold the first attempt that solved each task, from 1.
    folds: Vec<Vec<(TaskId, Option<usize>)>>,
}

impl Measured {
    /// Returns the mean over the folds of their auccess, on all tasks or on those of a template; `None` if no fold
    /// tests it.
    pub fn auccess(&self, template: Option<usize>) -> Option<f64> {
        self.mean(template, auccess)
    }

    /// Returns the mean share of tasks solved within a number of attempts, 0..=1.
    pub fn solved_within(&self, attempts: usize) -> f64 {
        self.mean(None, |firsts| solved_within(firsts, attempts)).unwrap_or_default()
    }

    fn mean(&self, template: Option<usize>, value: impl Fn(&[Option<usize>]) -> f64) -> Option<f64> {
        let of_fold = |fold: &Vec<(TaskId, Option<usize>)>| -> Vec<Option<usize>> {
            let asked = fold.iter().filter(|(task, _)| template.is_none_or(|number| task.template == number));
            asked.map(|&(_, first)| first).collect()
        };
        let values: Vec<f64> =
            self.folds.iter().map(of_fold).filter(|firsts| !firsts.is_empty()).map(|firsts| value(&firsts)).collect();
        (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
    }
}

/// The folds of the shipped models, within before cross.
pub fn shipped_folds() -> [FoldId; 2] {
    [Setup::Within, Setup::Cross].map(|setup| FoldId { setup, fold: SHIPPED_FOLD })
}

/// Reads all groups: the shipped models, then the main results; of each within before cross.
///
/// # Errors
/// If results are missing or damaged.
pub fn groups(results: &Path, shipped: &Shipped) -> anyhow::Result<Vec<Group>> {
    let mut groups = Vec::new();
    for fold in shipped_folds() {
        let of = format!("fold {}, the models on the page", fold.fold);
        groups.push(group(fold.setup, of, vec![shipped.read(&fold.to_string())?.0]));
    }
    let (within, cross): (Vec<Report>, Vec<Report>) = main_results(results)?
        .into_iter()
        .map(|result| result.report)
        .partition(|report| report.setup == Setup::Within);
    for reports in [within, cross] {
        let Some(Report { setup, .. }) = reports.first() else { continue };
        let numbers: Vec<u8> = reports.iter().map(|report| report.fold).collect();
        let of = match numbers.as_slice() {
            [fold] => format!("fold {fold} of the main results"),
            several => format!("mean over folds {} of the main results", listed(several)),
        };
        groups.push(group(*setup, of, reports));
    }
    Ok(groups)
}

fn group(setup: Setup, of: String, reports: Vec<Report>) -> Group {
    let mut agents: Vec<Measured> = Vec::new();
    for score in reports.into_iter().flat_map(|report| report.agents) {
        match agents.iter_mut().find(|measured| measured.agent == score.agent) {
            Some(measured) => measured.folds.push(score.first_solved),
            None => agents.push(Measured { agent: score.agent, folds: vec![score.first_solved] }),
        }
    }
    Group { setup, of, agents }
}

/// Returns ascending numbers as words; a row of neighbours by its ends.
fn listed(numbers: &[u8]) -> String {
    let runs = numbers.chunk_by(|number, next| number + 1 == *next).map(|run| match run {
        [first, .., last] => format!("{first}–{last}"),
        _ => run.iter().map(u8::to_string).collect(),
    });
    runs.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_listed_by_their_ends() {
        assert_eq!(listed(&[0, 1, 2]), "0–2");
        assert_eq!(listed(&[0, 2, 3, 7]), "0, 2–3, 7");
    }
}
