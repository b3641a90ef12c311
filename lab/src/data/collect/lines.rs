//! The lines of a `data collect` file, and their reader.

use std::path::Path;

use anyhow::ensure;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::VERSION;
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

impl CollectSettings {
    /// Number of tasks, and thus of lines, in a complete file.
    fn tasks(&self) -> usize {
        let template = self.template.and_then(|number| TEMPLATES.get(number).copied());
        TaskSelection { template, limit: self.limit }.ids().count()
    }
}

/// Reads a complete `data collect` file.
///
/// # Errors
/// If the file is missing, damaged or not complete, or if another version of the simulator found its solutions.
pub fn read_solutions(path: &Path) -> anyhow::Result<Vec<Solution>> {
    let (settings, lines) = journal::read::<TaskSolutions>(path)?;
    let CollectSettings { simulator, .. } = settings;
    let (name, tasks_left) = (path.display(), settings.tasks().saturating_sub(lines.len()));
    ensure!(
        simulator == VERSION,
        "the solutions in {name} were found by simulator {simulator}, but this is simulator {VERSION}: collect them again"
    );
    ensure!(
        tasks_left == 0,
        "{name} is not complete (tasks left: {tasks_left}): finish it with `pathlight-lab data collect`"
    );
    Ok(lines.iter().flat_map(TaskSolutions::solutions).collect())
}
