//! `pathlight collect`: solutions of the tasks, found among uniform random balls, as JSON lines.
//!
//! The file is a journal: the settings, then one line per task in ascending order, so the number of lines says where an
//! interrupted run continues. The file depends only on the settings, not on the number of cores.
//! `dataset::samples` makes training images from these lines.

use std::fmt::{self, Write as _};
use std::io::{self, Write as _};
use std::path::PathBuf;

use anyhow::ensure;
use pathlight::dataset::solutions::TaskSolutions;
use pathlight::puzzle::task::Task;
use pathlight::simulator;
use rayon::prelude::*;

use super::journal::Journal;
use super::progress::Progress;
use super::task_selection::TaskSelection;
pub use lines::{CollectEntry, CollectSettings, Collected, is_of_earlier_search, read_solutions};

mod lines;

/// Tasks that are searched at the same time and written together. An interruption loses at most their search.
const BLOCK: usize = 8;

/// Find balls that solve the tasks among uniform random ones, to train on
#[derive(clap::Args)]
pub struct Args {
    /// File to write, or to continue
    #[arg(long, default_value = "assets/solutions.jsonl")]
    pub out: PathBuf,

    /// Solutions to find per task
    #[arg(long, value_name = "N", default_value_t = 10)]
    pub per_task: usize,

    /// Most balls to simulate per task
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    pub max_rollouts: usize,

    #[command(flatten)]
    pub selection: TaskSelection,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        io::stdout().write_all(self.search()?.as_bytes())?;
        Ok(())
    }

    /// Searches, or continues with it. Returns how many tasks have fewer solutions than asked for, and the unsolved
    /// tasks by template.
    ///
    /// # Errors
    /// If the file cannot be continued or written.
    pub fn search(self) -> anyhow::Result<String> {
        let settings = CollectSettings {
            seed: self.seed,
            per_task: self.per_task,
            max_rollouts: self.max_rollouts,
            simulator: simulator::VERSION,
            template: self.selection.template(),
            limit: self.selection.limit,
        };
        let tasks = self.selection.tasks();
        let (mut journal, lines) = Journal::open::<CollectEntry>(&self.out, &settings)?;
        let mut searched: Vec<TaskSolutions> = Vec::new();
        for (line, task) in lines.into_iter().zip(&tasks) {
            match line {
                CollectEntry::Task(found) if found.task == task.id => searched.push(found),
                _ => anyhow::bail!("{} lacks the line of {}: remove the file", self.out.display(), task.id),
            }
        }
        let so_far = |searched: &[TaskSolutions]| {
            let rollouts: usize = searched.iter().map(|task| task.rollouts).sum();
            let found: usize = searched.iter().map(|task| task.balls.len()).sum();
            format!("{found} solutions of {} tasks, {rollouts} rollouts", searched.len())
        };
        let mut progress = Progress::new(Some(tasks.len() as u64));
        progress.advance(searched.len() as u64, so_far(&searched));
        for block in tasks[searched.len()..].chunks(BLOCK) {
            let search = |task: &Task| TaskSolutions::search(task, self.per_task, self.max_rollouts, self.seed);
            let found: Vec<TaskSolutions> = block.par_iter().map(search).collect();
            journal.append(&found)?;
            searched.extend(found);
            progress.advance(block.len() as u64, so_far(&searched));
        }
        progress.finish(&so_far(&searched));
        Ok(report(&searched, self.per_task)?)
    }
}

/// Returns how many tasks have fewer solutions than asked for, and the unsolved tasks by template.
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
