//! The results of `measure evaluate` on several folds, in a folder as `SETUP-FOLD.json`: what the tables over folds are
//! made of.

use std::path::Path;

use anyhow::ensure;
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::{FOLDS, FoldId, Setup};

use super::evaluate::Report;
use super::shipped::Measurement;
use crate::files::json_file;

/// Reads the results of a setup that exist, folds ascending. Each has to hold these agents; `script` makes them.
///
/// # Errors
/// If one is damaged, or is not of all test tasks of the fold in its name, by these agents and of today's version.
pub fn read(folder: &Path, setup: Setup, agents: &[AgentName], script: &str) -> anyhow::Result<Vec<Report>> {
    let mut reports = Vec::new();
    for fold in (0..FOLDS).map(|fold| FoldId { setup, fold }) {
        let path = folder.join(format!("{fold}.json"));
        if !path.exists() {
            continue;
        }
        let report: Report = json_file::read(&path, script)?;
        let names: Vec<String> = agents.iter().map(ToString::to_string).collect();
        ensure!(
            (FoldId { setup: report.setup, fold: report.fold }, report.tasks_of.as_str()) == (fold, "test")
                && report.is_whole(&fold.tasks().test)
                && agents.iter().all(|&agent| report.score(agent).is_some()),
            "{} does not hold the agents {}, of this version, on all test tasks of {fold}: remove it, and run \
             `{script}` again",
            path.display(),
            names.join(", "),
        );
        reports.push(report);
    }
    Ok(reports)
}
