//! The lines of a `data collect` file, and their reader.

use std::path::Path;

use anyhow::ensure;
use pathlight::puzzle::templates::TEMPLATES;
use serde::{Deserialize, Serialize};

use crate::data::solutions::{Solution, TaskSolutions};
use crate::data::task_selection::TaskSelection;
use crate::files::journal::{self, check_ball, check_task};

/// Settings that determine the content of a file.
#[derive(Serialize, Deserialize)]
pub struct CollectSettings {
    pub seed: u64,
    pub per_task: usize,
    pub max_rollouts: usize,
    /// `simulator::VERSION`
    pub simulator: u32,
    pub template: Option<usize>,
    pub limit: usize,
}

/// The lines after the settings, one per task.
impl journal::Entry for TaskSolutions {
    type Settings = CollectSettings;
    const COMMAND: &'static str = "data collect";

    fn check(&self) -> Result<(), String> {
        check_task(self.task)?;
        self.balls.iter().try_for_each(|ball| check_ball(&self.task, ball))
    }
}

/// The content of a `data collect` file.
pub struct Collected {
    pub solutions: Vec<Solution>,
    /// Version of the simulator that found the solutions.
    pub simulator: u32,
    /// Number of tasks still to be searched.
    tasks_left: usize,
}

impl Collected {
    /// Checks that the search is complete, so that no net is trained on part of it. `path` names the file in the error.
    ///
    /// # Errors
    /// If tasks are left to search.
    pub fn check_complete(&self, path: &Path) -> anyhow::Result<()> {
        ensure!(
            self.tasks_left == 0,
            "{} is not complete (tasks left: {}): finish it with `pathlight-lab data collect`",
            path.display(),
            self.tasks_left
        );
        Ok(())
    }
}

impl CollectSettings {
    /// Number of tasks, and thus of lines, in a complete file.
    fn tasks(&self) -> usize {
        let template = self.template.and_then(|number| TEMPLATES.get(number).copied());
        TaskSelection { template, limit: self.limit }.ids().count()
    }
}

/// Reads a `data collect` file.
///
/// # Errors
/// If the file is missing or damaged.
pub fn read_solutions(path: &Path) -> anyhow::Result<Collected> {
    let (settings, lines) = journal::read::<TaskSolutions>(path)?;
    let tasks_left = settings.tasks().saturating_sub(lines.len());
    let solutions = lines.iter().flat_map(TaskSolutions::solutions).collect();
    Ok(Collected { solutions, simulator: settings.simulator, tasks_left })
}
