//! Solutions of all 2,500 tasks, found by simulation, as JSON lines.
//!
//! The file is a journal: the settings, then solutions, and a line that closes each round. An interrupted run
//! continues after the last closed round. The file depends only on the settings, not on the number of cores, unless
//! it begins with another file's solutions (`--from`). `data::samples` makes training images from these lines.

use std::fmt::{self, Write as _};
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator;
use rayon::prelude::*;

use crate::data::solutions::{RoundResult, Search, Solution};
use crate::data::task_selection::TaskSelection;
use crate::files::journal::Journal;
use crate::progress::Progress;
pub use lines::{CollectEntry, CollectSettings, Collected, read_solutions};

mod lines;

/// The shipped solutions.
pub const SOLUTIONS: &str = "assets/solutions.jsonl";

/// What to search for, and where it is kept.
pub struct Settings {
    /// File to write, or to continue.
    pub out: PathBuf,
    /// Solutions to find per task.
    pub per_task: usize,
    /// Rounds in which all unfinished tasks are searched; a task tries 32 balls per round.
    pub rounds: usize,
    /// Extra rounds for tasks still unsolved; in these, a task stops at its first solution.
    pub persist: usize,
    pub selection: TaskSelection,
    /// Another file, whose solutions that still solve their tasks a new file begins with.
    pub from: Option<PathBuf>,
    /// Seed of all random draws.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            out: SOLUTIONS.into(),
            per_task: 10,
            rounds: 200,
            persist: 1500,
            selection: TaskSelection::default(),
            from: None,
            seed: 0,
        }
    }
}

impl Settings {
    /// Searches, or continues with it. Returns how many tasks have fewer solutions than asked for, and the unsolved
    /// tasks by template.
    ///
    /// # Errors
    /// If the file cannot be continued or written.
    pub fn search(&self, progress: &mut dyn Progress) -> anyhow::Result<String> {
        let settings = CollectSettings {
            seed: self.seed,
            per_task: self.per_task,
            simulator: simulator::VERSION,
            template: self.selection.template(),
            limit: self.selection.limit,
            rounds: self.rounds,
        };
        let mut searches: Vec<Search> = self.selection.tasks().into_iter().map(Search::new).collect();
        let (mut journal, lines) = Journal::open::<CollectEntry>(&self.out, &settings)?;
        let (closed, first, mut rollouts) = restore(&lines, &mut searches)
            .with_context(|| format!("cannot continue {}: write to another file with --out", self.out.display()))?;
        ensure!(
            first == 0 || self.from.is_none(),
            "{} is already begun, and --from is only for a new file: write to another file with --out, or leave --from \
             out",
            self.out.display()
        );
        journal.keep(closed)?;
        let found = |searches: &[Search]| searches.iter().map(|search| search.found.len()).sum::<usize>();
        progress.begin((searches.len() * self.per_task) as u64);
        progress.advance(found(&searches) as u64, format!("round {first}"));
        for round in first..self.rounds.saturating_add(self.persist) {
            let per_task = if round < self.rounds { self.per_task } else { self.per_task.min(1) };
            if searches.iter().all(|search| search.found.len() >= per_task) {
                break;
            }
            // What the tasks of each template know together when the round begins.
            let mut sibling_solutions: Vec<Vec<Ball>> = vec![Vec::new(); TEMPLATES.len()];
            for search in &searches {
                sibling_solutions[search.task.template].extend_from_slice(&search.found);
            }
            let results: Vec<RoundResult> = match &self.from {
                Some(file) if round == 0 => self.retry_solutions(file, &searches)?,
                _ => searches
                    .par_iter()
                    .map(|search| search.round(&sibling_solutions[search.task.template], per_task, self.seed, round))
                    .collect(),
            };
            let mut lines = Vec::new();
            let before = found(&searches);
            for (search, result) in searches.iter_mut().zip(results) {
                let task = search.task;
                lines.extend(result.found.iter().map(|&ball| CollectEntry::Solution(Solution { task, ball })));
                search.found.extend(result.found);
                rollouts += result.rollouts;
            }
            lines.push(CollectEntry::Round { round, rollouts });
            journal.append(&lines)?;
            let unsolved = searches.iter().filter(|search| search.found.is_empty()).count();
            let so_far = format!(
                "round {round}: {} solutions, {unsolved} tasks unsolved, {rollouts} rollouts",
                found(&searches)
            );
            progress.advance((found(&searches) - before) as u64, so_far);
        }
        progress.finish(&format!("{} solutions of {} tasks, {rollouts} rollouts", found(&searches), searches.len()));
        Ok(report(&searches, self.per_task)?)
    }

    /// Tries the solutions of another file, as a round of its own.
    fn retry_solutions(&self, file: &Path, searches: &[Search]) -> anyhow::Result<Vec<RoundResult>> {
        let mut solutions = read_solutions(file)?.solutions;
        solutions.sort_by_key(|solution| solution.task);
        let of = |task: TaskId| {
            let of_task = solutions.iter().filter(move |solution| solution.task == task);
            of_task.map(|solution| solution.ball).take(self.per_task)
        };
        Ok(searches.par_iter().map(|search| search.retry(of(search.task))).collect())
    }
}

/// Takes over what the closed rounds found. Returns the number of lines up to the end of the last closed round, the
/// round to continue with, and the rollouts so far.
fn restore(lines: &[CollectEntry], searches: &mut [Search]) -> anyhow::Result<(usize, usize, usize)> {
    let (mut closed, mut next, mut rollouts) = (0, 0, 0);
    for (index, line) in lines.iter().enumerate() {
        if let CollectEntry::Round { round, rollouts: total } = line {
            (closed, next, rollouts) = (index + 1, round.saturating_add(1), *total);
        }
    }
    for line in &lines[..closed] {
        if let &CollectEntry::Solution(Solution { task, ball }) = line {
            let search = searches.binary_search_by_key(&task, |search| search.task);
            let search = search.ok().with_context(|| format!("it has {task}, which is not searched now"))?;
            searches[search].found.push(ball);
        }
    }
    Ok((closed, next, rollouts))
}

/// Returns how many tasks have fewer solutions than asked for, and the unsolved tasks by template.
fn report(searches: &[Search], per_task: usize) -> Result<String, fmt::Error> {
    let mut text = String::new();
    let fewer = searches.iter().filter(|search| search.found.len() < per_task).count();
    let unsolved = searches.iter().filter(|search| search.found.is_empty()).count();
    writeln!(text, "{fewer} of {} tasks have fewer than {per_task} solutions, {unsolved} have none", searches.len())?;
    for of_template in searches.chunk_by(|a, b| a.task.template == b.task.template) {
        let mut unsolved = of_template.iter().filter(|search| search.found.is_empty());
        if let Some(first) = unsolved.next() {
            let count = 1 + unsolved.count();
            writeln!(text, "{:05}: {count} without a solution, the first is {}", first.task.template, first.task)?;
        }
    }
    Ok(text)
}
