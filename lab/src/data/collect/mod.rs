//! Searches for solutions of the tasks among uniform random balls, and writes them as JSON lines.
//!
//! The file is a journal: the settings, then one line per task in ascending order. The number of lines tells where to
//! continue an interrupted run. The content depends only on the settings, not on the number of cores. `training::paths`
//! makes training images from these lines.

use std::fmt::{self, Write as _};
use std::path::PathBuf;

use anyhow::ensure;
use pathlight::puzzle::task::Task;
use pathlight::simulator;
use rayon::prelude::*;

use crate::data::solutions::TaskSolutions;
use crate::data::task_selection::TaskSelection;
use crate::files::journal::Journal;
use crate::progress::Progress;
pub use lines::{CollectSettings, read_solutions};

mod lines;

/// The shipped solutions.
pub const SOLUTIONS: &str = "assets/solutions.jsonl";

/// Tasks searched in parallel and written together: the most that an interruption loses.
const BLOCK: usize = 8;

/// What to search for, and where to write it.
pub struct Settings {
    /// File to write or continue.
    pub out: PathBuf,
    /// Solutions to find per task.
    pub per_task: usize,
    /// Maximum number of balls to simulate per task.
    pub max_rollouts: usize,
    pub selection: TaskSelection,
    /// Seed of all random draws.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            out: SOLUTIONS.into(),
            per_task: 10,
            max_rollouts: 1_000_000,
            selection: TaskSelection::default(),
            seed: 0,
        }
    }
}

impl Settings {
    /// Starts or continues the search. Returns how many tasks have fewer solutions than `per_task`, and the unsolved
    /// tasks by template.
    ///
    /// # Errors
    /// If the file cannot be continued or written.
    pub fn search(&self, progress: &mut dyn Progress) -> anyhow::Result<String> {
        let settings = CollectSettings {
            seed: self.seed,
            per_task: self.per_task,
            max_rollouts: self.max_rollouts,
            simulator: simulator::VERSION,
            template: self.selection.template(),
            limit: self.selection.limit,
        };
        let tasks = self.selection.tasks();
        let (mut journal, mut searched) = Journal::open::<TaskSolutions>(&self.out, &settings, progress)?;
        searched.truncate(tasks.len());
        for (line, task) in searched.iter().zip(&tasks) {
            ensure!(
                line.task == task.id,
                "{} has task {} where task {} is expected: remove the file",
                self.out.display(),
                line.task,
                task.id
            );
        }
        progress.begin(tasks.len() as u64);
        progress.advance(searched.len() as u64, summary(&searched));
        for block in tasks[searched.len()..].chunks(BLOCK) {
            let search = |task: &Task| TaskSolutions::search(task, self.per_task, self.max_rollouts, self.seed);
            let found: Vec<TaskSolutions> = block.par_iter().map(search).collect();
            journal.append(&found)?;
            searched.extend(found);
            progress.advance(block.len() as u64, summary(&searched));
        }
        progress.finish(&summary(&searched));
        Ok(report(&searched, self.per_task)?)
    }
}

/// Summarises what has been found so far.
fn summary(searched: &[TaskSolutions]) -> String {
    let rollouts: usize = searched.iter().map(|task| task.rollouts).sum();
    let found: usize = searched.iter().map(|task| task.balls.len()).sum();
    format!("{found} solutions of {} tasks, {rollouts} rollouts", searched.len())
}

/// Reports how many tasks have fewer solutions than `per_task`, and the unsolved tasks by template.
fn report(searched: &[TaskSolutions], per_task: usize) -> Result<String, fmt::Error> {
    let mut text = String::new();
    let fewer = searched.iter().filter(|task| task.balls.len() < per_task).count();
    let unsolved = searched.iter().filter(|task| task.balls.is_empty()).count();
    writeln!(text, "{fewer} of {} tasks have fewer than {per_task} solutions, {unsolved} have none", searched.len())?;
    for of_template in searched.chunk_by(|a, b| a.task.template == b.task.template) {
        let mut unsolved = of_template.iter().filter(|task| task.balls.is_empty());
        if let Some(first) = unsolved.next() {
            let count = 1 + unsolved.count();
            writeln!(text, "{:05}: {count} without a solution, the first is {}", first.task.template, first.task)?;
        }
    }
    Ok(text)
}
