//! The lines of a file of `data collect`, and reading them.

use std::path::Path;

use anyhow::ensure;
use pathlight::puzzle::templates::TEMPLATES;
use serde::{Deserialize, Serialize};

use crate::data::solutions::{Solution, TaskSolutions};
use crate::data::task_selection::TaskSelection;
use crate::files::journal::{self, check_ball, check_task};

/// What determines the content of a file.
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

/// The lines after the settings, one for each task.
impl journal::Entry for TaskSolutions {
    type Settings = CollectSettings;
    const COMMAND: &'static str = "data collect";

    fn check(&self) -> Result<(), String> {
        check_task(self.task)?;
        self.balls.iter().try_for_each(|ball| check_ball(&self.task, ball))
    }
}

/// What a file of `data collect` holds.
pub struct Collected {
    pub solutions: Vec<Solution>,
    /// Version of the simulator that found them.
    pub simulator: u32,
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
    /// The number of tasks that the file has a line for in the end.
    fn tasks(&self) -> usize {
        let template = self.template.and_then(|number| TEMPLATES.get(number).copied());
        TaskSelection { template, limit: self.limit }.ids().count()
    }
}

/// Reads a file of `data collect`.
///
/// # Errors
/// Says what is wrong with the file.
pub fn read_solutions(path: &Path) -> anyhow::Result<Collected> {
    let (settings, lines) = journal::read::<TaskSolutions>(path)?;
    let tasks_left = settings.tasks().saturating_sub(lines.len());
    let solutions = lines.iter().flat_map(TaskSolutions::solutions).collect();
    Ok(Collected { solutions, simulator: settings.simulator, tasks_left })
}
