//! The lines of a file of `data collect`, and reading them.

use std::path::Path;

use anyhow::ensure;
use pathlight::puzzle::templates::TEMPLATES;
use serde::{Deserialize, Serialize};

use crate::data::solutions::{Solution, TaskSolutions};
use crate::data::task_selection::TaskSelection;
use crate::files::journal::{self, check_ball, check_task};

/// What determines the content of a file. Absent fields take their defaults.
#[derive(Serialize, Deserialize)]
pub struct CollectSettings {
    pub seed: u64,
    #[serde(alias = "wanted")]
    pub per_task: usize,
    /// 0 in files of the search in rounds.
    #[serde(default)]
    pub max_rollouts: usize,
    /// `simulator::VERSION`
    pub simulator: u32,
    #[serde(default)]
    pub template: Option<usize>,
    #[serde(default = "default_limit")]
    pub limit: usize,
}

fn default_limit() -> usize {
    100
}

/// A line after the settings.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
pub enum CollectEntry {
    Task(TaskSolutions),
    /// A line of an earlier version, which searched around known solutions, in rounds.
    Solution(Solution),
    /// The end of such a round, and the rollouts so far.
    Round {
        round: usize,
        rollouts: usize,
    },
}

impl journal::Entry for CollectEntry {
    type Settings = CollectSettings;
    const COMMAND: &'static str = "data collect";

    fn check(&self) -> Result<(), String> {
        match self {
            CollectEntry::Task(TaskSolutions { task, balls, .. }) => {
                check_task(*task)?;
                balls.iter().try_for_each(|ball| check_ball(task, ball))
            }
            CollectEntry::Solution(Solution { task, ball }) => check_task(*task).and_then(|()| check_ball(task, ball)),
            CollectEntry::Round { .. } => Ok(()),
        }
    }
}

/// What a file of `data collect` holds.
pub struct Collected {
    pub solutions: Vec<Solution>,
    /// Version of the simulator that found them.
    pub simulator: u32,
    /// Balls simulated in the search.
    pub rollouts: usize,
    /// Tasks of the search that are not searched yet.
    tasks_left: usize,
}

impl Collected {
    /// Checks that the search is complete, so that no nets are trained on a part of it. `path` is its file.
    ///
    /// # Errors
    /// If tasks are left.
    pub fn check_complete(&self, path: &Path) -> anyhow::Result<()> {
        ensure!(
            self.tasks_left == 0,
            "{} is not complete (tasks left: {}): let `pathlight-lab data collect` finish it",
            path.display(),
            self.tasks_left
        );
        Ok(())
    }
}

impl CollectSettings {
    /// The number of tasks that the file has a line for in the end; none in files of the search in rounds.
    fn tasks(&self) -> usize {
        if self.max_rollouts == 0 {
            return 0;
        }
        let template = self.template.and_then(|number| TEMPLATES.get(number).copied());
        TaskSelection { template, limit: self.limit }.ids().count()
    }
}

/// Reads a file of `data collect`.
///
/// # Errors
/// Says what is wrong with the file.
pub fn read_solutions(path: &Path) -> anyhow::Result<Collected> {
    let (settings, lines) = journal::read::<CollectEntry>(path)?;
    let (simulator, tasks_left) = (settings.simulator, settings.tasks());
    let mut collected = Collected { solutions: Vec::new(), simulator, rollouts: 0, tasks_left };
    for line in lines {
        match line {
            CollectEntry::Task(task) => {
                collected.solutions.extend(task.solutions());
                collected.rollouts += task.rollouts;
                collected.tasks_left = collected.tasks_left.saturating_sub(1);
            }
            CollectEntry::Solution(solution) => collected.solutions.push(solution),
            CollectEntry::Round { rollouts, .. } => collected.rollouts = rollouts,
        }
    }
    Ok(collected)
}

/// Whether a file is of the earlier search around known solutions, which cannot be continued. The nets of the results
/// were trained on such a file.
///
/// # Errors
/// Says what is wrong with the file.
pub fn is_of_earlier_search(path: &Path) -> anyhow::Result<bool> {
    // A file that is cut off in its settings is mended when it is opened to be continued.
    let has_settings = path.exists() && journal::is_file_of::<CollectEntry>(path)?;
    Ok(has_settings && journal::read::<CollectEntry>(path)?.0.max_rollouts == 0)
}
