//! `pathlight solve-rates`: how often chance solves a task, here and in PHYRE.
//!
//! The reference folder has solve_rates.json: for each task how many of at least 10,000 uniform actions were
//! valid, and how many of those solved it. Actions that stick out of the scene were never counted there, so they
//! are drawn again here. The file is no part of the project.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use pathlight::puzzle::action::{Action, Invalid};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::{TEMPLATES, Template};
use pathlight::simulator::outcome;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use serde::Deserialize;

use super::progress::Progress;

/// Compare how often random actions are valid and solve with PHYRE's figures
#[derive(clap::Args)]
pub struct Args {
    /// Folder with solve_rates.json
    #[arg(long, value_name = "DIR")]
    reference: PathBuf,

    /// Random actions inside the scene for each task
    #[arg(long, value_name = "N", default_value_t = 100)]
    actions: u32,

    /// Only the first N tasks of each template, for a quick look
    #[arg(long, value_name = "N", default_value_t = 100)]
    limit: usize,

    /// The same seed draws the same actions
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

/// What came of the actions of a task, or of several.
#[derive(Clone, Copy, Default, Deserialize)]
struct Counts {
    valid: u32,
    invalid: u32,
    solved: u32,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let path = self.reference.join("solve_rates.json");
        let text = fs::read_to_string(&path)
            .with_context(|| format!("cannot read {}: --reference names the folder it is in", path.display()))?;
        let reference: BTreeMap<TaskId, Counts> =
            serde_json::from_str(&text).with_context(|| format!("in {}", path.display()))?;

        let mut progress = Progress::new(Some(TEMPLATES.len() as u64));
        println!(
            "Random actions inside the scene, %: valid of all, and solving of the valid; mean over the tasks of a template"
        );
        println!("{:8}{:^18}{:^18}", "", "valid", "solving");
        println!("{:8}{:>9}{:>9}{:>9}{:>9}", "", "here", "PHYRE", "here", "PHYRE");
        let mut all = Vec::new();
        for template in TEMPLATES {
            let rows = self.rates(template, &reference)?;
            println!("{:05}   {}", template.number, means(&rows));
            all.extend(rows);
            progress.advance(1, format!("template {:05}", template.number));
        }
        println!("{:8}{}", "all", means(&all));
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
            let [valid, solving] = self.try_out(task).shares();
            let [their_valid, their_solving] = theirs.shares();
            Ok([valid, their_valid, solving, their_solving])
        };
        tasks.par_iter().map(rates).collect()
    }

    fn try_out(&self, task: &Task) -> Counts {
        let mut random = Pcg64Mcg::seed_from_u64(task.id.seed(self.seed));
        let mut counts = Counts::default();
        while counts.valid + counts.invalid < self.actions {
            let action = Action { x: random.random(), y: random.random(), r: random.random() };
            match action.place(&task.scene).and_then(|ball| outcome(&task.scene, Some(ball))) {
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
    /// Valid of all, solving of the valid.
    fn shares(self) -> [f64; 2] {
        let share = |part: u32, whole: u32| f64::from(part) / f64::from(whole.max(1));
        [share(self.valid, self.valid + self.invalid), share(self.solved, self.valid)]
    }
}

fn means(rows: &[[f64; 4]]) -> String {
    let mean = |column: usize| 100.0 * rows.iter().map(|row| row[column]).sum::<f64>() / rows.len().max(1) as f64;
    [0, 1, 2, 3].map(|column| format!("{:>9.2}", mean(column))).concat()
}
