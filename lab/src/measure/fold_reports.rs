//! What the tables over folds are made of: files of `measure evaluate` in a folder, `SETUP-FOLD.json` for several
//! folds, or `all-tasks.json` for nets that have seen no task.

use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::FoldId;

use super::report::Report;
use super::shipped::Measurement;
use super::task_set::TaskSet;
use crate::files::json_file;

/// The file of results on all tasks.
pub const ALL_TASKS: &str = "all-tasks.json";

/// Reads the results in a folder, at least one, within before cross, folds ascending. Each has to hold these agents,
/// and `settings` have to agree; `script` makes them.
///
/// # Errors
/// If there are none, one is damaged or is not of all test tasks of the fold in its name, by these agents, or they were
/// made with different settings.
pub fn read<S: PartialEq>(
    folder: &Path,
    agents: &[AgentName],
    script: &str,
    settings: impl Fn(&Report) -> S,
) -> anyhow::Result<Vec<Report>> {
    let mut reports: Vec<Report> = Vec::new();
    for fold in FoldId::all() {
        let path = folder.join(format!("{fold}.json"));
        if !path.exists() {
            continue;
        }
        let name = path.display();
        let report: Report = json_file::read(&path, script)?;
        ensure!(
            (report.fold_id(), report.tasks_of) == (fold, TaskSet::Test)
                && report.is_whole(&fold.tasks().test, report.simulator)
                && agents.iter().all(|&agent| report.score(agent).is_some()),
            "{name} does not hold the agents {}, of this version, on all test tasks of {fold}: remove it, and run \
             `{script}` again",
            names(agents),
        );
        if let Some(first) = reports.first() {
            ensure!(
                settings(&report) == settings(first),
                "{name} was made with other settings than {}-{}.json: remove one of them, and run `{script}` again",
                first.setup,
                first.fold
            );
        }
        reports.push(report);
    }
    reports
        .first()
        .with_context(|| format!("there are no results in {}: make them with `{script}`", folder.display()))?;
    Ok(reports)
}

/// Reads the results on all tasks in a folder. They have to hold these agents; `script` makes them.
///
/// # Errors
/// If there are none, or they are damaged, or are not of all tasks, by these agents.
pub fn read_all_tasks(folder: &Path, agents: &[AgentName], script: &str) -> anyhow::Result<Report> {
    let path = folder.join(ALL_TASKS);
    let report: Report = json_file::read(&path, script)?;
    ensure!(
        report.tasks_of == TaskSet::All
            && report.is_whole(&TaskSet::All.tasks(FoldId::default(), None), report.simulator)
            && agents.iter().all(|&agent| report.score(agent).is_some()),
        "{} does not hold the agents {}, of this version, on all tasks: remove it, and run `{script}` again",
        path.display(),
        names(agents),
    );
    Ok(report)
}

/// The names of agents, for a message.
fn names(agents: &[AgentName]) -> String {
    agents.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}
