//! Our agents over all folds, and what others have published, for the report, the figures and the page. What the paper
//! published by template is in `measure::paper_table`.

use std::path::Path;

use anyhow::ensure;
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::puzzle::task::TaskId;
use serde::Serialize;

use super::fold_result::{self, FoldResult};
use super::other_data::{self, Table};
use crate::files::json_file;
use crate::measure::agents::{AGENTS, MeasuredAgent};
use crate::measure::paper_table::{self, ByTemplate};
use crate::measure::report::Report;
use crate::measure::shipped::Measurement;
use crate::measure::task_set::TaskSet;

/// Published auccess, mean over the ten folds, on PHYRE's own engine.
#[derive(Serialize)]
pub struct Published {
    /// The name of the method, the same in every language; empty if it goes by its authors.
    method: &'static str,
    source: &'static str,
    url: &'static str,
    /// Within and cross.
    pub auccess: [&'static str; 2],
}

const HARTER: [&str; 2] = ["Harter et al. (2020)", "https://arxiv.org/abs/2011.07357"];

/// With what reports call them. Harter et al. (2020), Table 1, for their nets and for DQN; the benchmark (PHYRE 0.2.2)
/// for the random agent.
pub const REPORTED: [(&str, Published); 3] = [
    ("DQN", Published { method: "DQN", source: HARTER[0], url: HARTER[1], auccess: ["77", "37"] }),
    ("the paper's nets", Published { method: "", source: HARTER[0], url: HARTER[1], auccess: ["62", "31"] }),
    (
        "RAND",
        Published {
            method: "RAND",
            source: "Bakhtin et al. (2019)",
            url: "https://arxiv.org/abs/1908.05656",
            auccess: ["13.7", "13.0"],
        },
    ),
];

/// The best without learning across test tasks that we know of, one a setup.
const BEST: [Published; 2] = [
    Published {
        method: "",
        source: "Ahmed et al. (2021)",
        url: "https://arxiv.org/abs/2102.10336",
        auccess: ["86.2", "–"],
    },
    Published {
        method: "RPIN",
        source: "Qi et al. (2021)",
        url: "https://arxiv.org/abs/2008.02265",
        auccess: ["–", "42.2"],
    },
];

/// The auccess of our agents and the published ones, as the page shows them.
#[derive(Serialize)]
pub struct Comparison {
    ours: Vec<AgentMean>,
    /// The auccess of the online agent, within and cross, if its net learned from proposed balls or random scenes;
    /// `None` unless all ten folds are measured.
    online_with_other_data: [Option<String>; 2],
    published: Vec<Published>,
    /// The paper's nets by template, within and cross.
    #[serde(skip_serializing_if = "Option::is_none")]
    paper: Option<[ByTemplate; 2]>,
}

/// An agent's auccess, within and cross: the mean over the folds, and the deviation.
#[derive(Serialize)]
pub struct AgentMean {
    pub agent: AgentName,
    pub auccess: [String; 2],
}

/// Reads the main results in a folder. If its subfolder `paper` has results, adds the score of the paper's nets to each
/// fold.
///
/// # Errors
/// If there are no results, one is damaged, results were made with different settings, or those of the paper's nets are
/// not of the same tasks.
pub fn main_results(folder: &Path) -> anyhow::Result<Vec<FoldResult>> {
    let mut results = fold_result::read(folder)?;
    let paper = folder.join("paper");
    if !FoldId::all().any(|fold| paper.join(format!("{fold}.json")).exists()) {
        return Ok(results);
    }
    for mut of_paper in paper_table::read(&paper)? {
        let fold = of_paper.fold_id();
        let Some(FoldResult { report, .. }) = results.iter_mut().find(|result| result.report.fold_id() == fold) else {
            continue;
        };
        of_paper.agents.retain(|score| score.agent == AgentName::Paper);
        let measured = report.agents.first().map(|score| &score.first_solved);
        let tasks: Vec<TaskId> = measured.into_iter().flatten().map(|&(task, _)| task).collect();
        ensure!(
            of_paper.is_of(&tasks) && (of_paper.seed, of_paper.simulator) == (report.seed, report.simulator),
            "the results of {fold} in {} and in {} are not of the same tasks, seed and simulator: choose another \
             folder with --results",
            folder.display(),
            paper.display()
        );
        report.agents.extend(of_paper.agents);
        report.agents.sort_by_key(|score| score.agent as usize);
    }
    Ok(results)
}

/// Compares the main results in a folder with the published ones; and what its folders `proposed-balls`,
/// `random-scenes` and `paper` hold, if it has them.
///
/// # Errors
/// If a result is missing, damaged or not of all test tasks of its fold, or results were made with different settings.
pub fn comparison(results: &Path) -> anyhow::Result<Comparison> {
    let folds = main_results(results)?;
    for fold in FoldId::all() {
        let is_whole = |report: &Report| report.fold_id() == fold && report.is_of(&fold.tasks().test);
        ensure!(
            folds.iter().any(|result| is_whole(&result.report)),
            "{} has no result on all test tasks of {fold}: run `pathlight-lab reproduce`, or name another folder with \
             --main",
            results.display()
        );
    }
    let paper = Some(results.join("paper")).filter(|folder| folder.exists());
    Ok(Comparison {
        ours: our_means(&folds).into_iter().chain(listed(results)?).collect(),
        online_with_other_data: online_with_other_data(results)?,
        published: BEST.into_iter().chain(REPORTED.map(|(_, published)| published)).collect(),
        paper: paper.map(|folder| paper_table::by_template(&folder)).transpose()?,
    })
}

/// Returns the auccess of the online agent, within if its net learned from balls that it proposed, and cross if it
/// learned from random scenes; `None` unless all ten folds are measured.
///
/// # Errors
/// If a result is damaged, or results were made with different settings.
pub fn online_with_other_data(results: &Path) -> anyhow::Result<[Option<String>; 2]> {
    let online = |table: Table| other_data::online(table, &results.join(table.name()));
    Ok([online(Table::ProposedBalls)?, online(Table::RandomScenes)?])
}

/// Returns the mean auccess of all agents.
pub fn our_means(results: &[FoldResult]) -> Vec<AgentMean> {
    let mean = |setup: Setup, agent: AgentName| {
        let of_setup = results.iter().map(|result| &result.report).filter(|report| report.setup == setup);
        mean_and_deviation(&scores(of_setup, agent))
    };
    let of_agent = |agent| AgentMean { agent, auccess: [Setup::Within, Setup::Cross].map(|setup| mean(setup, agent)) };
    on_folds().map(|measured| of_agent(measured.agent)).collect()
}

/// Returns the auccess of RAND as it was published. It learns nothing, so it was measured on all tasks at once; `None`
/// if the folder has no such file.
///
/// # Errors
/// If the file is damaged, or not of all tasks.
pub fn listed(results: &Path) -> anyhow::Result<Option<AgentMean>> {
    let path = results.join("listed.json");
    if !path.exists() {
        return Ok(None);
    }
    const COMMAND: &str = "pathlight-lab measure evaluate --agent listed --all-tasks --json results/listed.json";
    let report: Report = json_file::read(&path, COMMAND)?;
    let agent = AgentName::Listed;
    ensure!(
        report.is_whole(&TaskSet::All.tasks(FoldId::default(), None), report.simulator)
            && report.score(agent).is_some(),
        "{} does not hold the agent {agent} on all tasks: remove it, and run `{COMMAND}` again",
        path.display()
    );
    let mean = |setup| {
        let folds = FoldId::all().filter(|fold| fold.setup == setup).map(|fold| report.on_fold(fold));
        mean_and_deviation(&scores(folds.collect::<Vec<_>>().iter(), agent))
    };
    Ok(Some(AgentMean { agent, auccess: [Setup::Within, Setup::Cross].map(mean) }))
}

/// The agents of each fold; RAND has one result for all.
pub fn on_folds() -> impl Iterator<Item = &'static MeasuredAgent> {
    AGENTS.iter().filter(|row| row.agent != AgentName::Listed)
}

/// Returns the auccess of an agent in the reports that have it.
pub fn scores<'a>(reports: impl Iterator<Item = &'a Report>, agent: AgentName) -> Vec<f64> {
    reports.filter_map(|report| report.score(agent)).map(|[auccess, ..]| auccess).collect()
}

/// Formats the mean, and the sample standard deviation if there are several numbers.
pub fn mean_and_deviation(numbers: &[f64]) -> String {
    let count = numbers.len() as f64;
    let mean = numbers.iter().sum::<f64>() / count;
    match numbers.len() {
        0 => "–".to_string(),
        1 => format!("{mean:.1}"),
        _ => {
            let variance = numbers.iter().map(|number| (number - mean).powi(2)).sum::<f64>() / (count - 1.0);
            format!("{mean:.1} ± {:.1}", variance.sqrt())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_printed_with_their_deviation() {
        assert_eq!(mean_and_deviation(&[]), "–");
        assert_eq!(mean_and_deviation(&[50.0]), "50.0");
        assert_eq!(mean_and_deviation(&[1.0, 3.0]), "2.0 ± 1.4");
    }
}
