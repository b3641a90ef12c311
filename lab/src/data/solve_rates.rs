//! How often uniformly random actions solve a task, here and in PHYRE.
//!
//! The reference folder has solve_rates.json: for each task how many of at least 10,000 uniform actions were valid, and
//! how many of those solved it. It is not part of the project. Actions whose ball sticks out of the scene, before or
//! after it is rounded, were not counted as invalid there, so other actions are drawn for them here too. With 4,000
//! actions per task, PHYRE's 73.27 % valid compare to 73.25 % by this rule; counting balls that leave the scene by
//! rounding as invalid yields 73.17 %.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::PathBuf;

use anyhow::Context;
use pathlight::puzzle::action::{Action, Invalid, Obstacles};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::{TEMPLATES, Template};
use pathlight::puzzle::utf8::utf8;
use pathlight::simulator::outcome;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use serde::Deserialize;

use crate::progress::Progress;

/// What to compare.
pub struct Settings {
    /// Folder with solve_rates.json.
    pub reference: PathBuf,
    /// Random actions inside the scene per task.
    pub actions: u32,
    /// Only the first tasks of each template.
    pub limit: usize,
    /// Seed of the random actions.
    pub seed: u64,
}

/// The outcomes of the actions of a task.
#[derive(Clone, Copy, Default, Deserialize)]
struct Counts {
    valid: u32,
    invalid: u32,
    solved: u32,
}

impl Settings {
    /// Writes a table with a row for each template, which appears once it is measured.
    ///
    /// # Errors
    /// If the reference cannot be read, or nobody takes the table.
    pub fn compare(&self, out: &mut dyn Write, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let path = self.reference.join("solve_rates.json");
        let cannot_read = || format!("cannot read {}: --reference names the folder it is in", path.display());
        let bytes = fs::read(&path).with_context(cannot_read)?;
        let text = utf8(&bytes).with_context(cannot_read)?;
        let reference: BTreeMap<TaskId, Counts> =
            serde_json::from_str(text).with_context(|| format!("in {}", path.display()))?;

        progress.begin(TEMPLATES.len() as u64);
        writeln!(
            out,
            "Random actions inside the scene, %: valid of all, and solving of the valid; mean over the tasks of a \
             template"
        )?;
        writeln!(out, "{:8}{:^18}{:^18}", "", "valid", "solving")?;
        writeln!(out, "{:8}{:>9}{:>9}{:>9}{:>9}", "", "here", "PHYRE", "here", "PHYRE")?;
        let mut all = Vec::new();
        for template in TEMPLATES {
            let rows = self.rates(template, &reference)?;
            writeln!(out, "{:05}   {}", template.number, means(&rows))?;
            all.extend(rows);
            progress.advance(1, format!("template {:05}", template.number));
        }
        writeln!(out, "{:8}{}", "all", means(&all))?;
        progress.finish(&format!("{} tasks", all.len()));
        Ok(())
    }

    /// For each task: valid and solving here, valid and solving in PHYRE.
    fn rates(
        &self,
        template: &'static Template,
        reference: &BTreeMap<TaskId, Counts>,
    ) -> anyhow::Result<Vec<[f64; 4]>> {
        let tasks: Vec<Task> = Task::of(template).take(self.limit).collect();
        let rates = |task: &Task| {
            let theirs =
                reference.get(&task.id).with_context(|| format!("solve_rates.json has no task {}", task.id))?;
            let [valid, solving] = self.try_actions(task).rates();
            let [their_valid, their_solving] = theirs.rates();
            Ok([valid, their_valid, solving, their_solving])
        };
        tasks.par_iter().map(rates).collect()
    }

    fn try_actions(&self, task: &Task) -> Counts {
        let obstacles = Obstacles::new(&task.scene);
        let mut random = Pcg64Mcg::seed_from_u64(task.id.seed(self.seed));
        let mut counts = Counts::default();
        while counts.valid + counts.invalid < self.actions {
            let action = Action { x: random.random(), y: random.random(), r: random.random() };
            match obstacles.place(action).and_then(|ball| outcome(&task.scene, Some(ball))) {
                Ok(outcome) => {
                    counts.valid += 1;
                    counts.solved += u32::from(outcome.solved);
                }
                Err(Invalid::Outside) => {}
                Err(_) => counts.invalid += 1,
            }
        }
        counts
    }
}

impl Counts {
    /// Fraction of valid actions, and fraction of solving ones among the valid.
    fn rates(self) -> [f64; 2] {
        let rate = |part: u32, whole: u32| f64::from(part) / f64::from(whole.max(1));
        [rate(self.valid, self.valid + self.invalid), rate(self.solved, self.valid)]
    }
}

/// Formats the mean of each column, %.
fn means(rows: &[[f64; 4]]) -> String {
    let mean = |column: usize| 100.0 * rows.iter().map(|row| row[column]).sum::<f64>() / rows.len().max(1) as f64;
    [0, 1, 2, 3].map(|column| format!("{:>9.2}", mean(column))).concat()
}
