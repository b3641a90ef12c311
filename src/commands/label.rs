//! `pathlight label`: balls with their outcome for all tasks, as JSON lines, to train a judge on.
//!
//! A line holds some balls of one task; round after round, every task gets a line, so the number of lines says
//! where a run that was cut off goes on. The balls follow from the seed and the solutions alone.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::action::Ball;
use pathlight::labels::Labels;
use pathlight::task::{Task, TaskId};
use pathlight::templates::TEMPLATES;
use rayon::prelude::*;

use super::collect::read_solutions;
use super::progress::Progress;

/// Balls of a task in a line.
const BALLS: usize = 64;

/// Lines that are written together.
const BLOCK: usize = 100;

/// Try balls on all tasks and keep their outcomes, to train a judge on
#[derive(clap::Args)]
pub struct Args {
    /// The file to write, or to go on with
    #[arg(long, default_value = "target/labels.jsonl")]
    out: PathBuf,

    /// Solutions to draw balls about, from `pathlight collect`
    #[arg(long, default_value = "assets/solutions.jsonl")]
    solutions: PathBuf,

    /// Rounds; in each, every task tries 64 balls
    #[arg(long, default_value_t = 8)]
    rounds: usize,

    /// Seed of all that is drawn
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let tasks: Vec<Task> = TEMPLATES.iter().flat_map(|template| Task::of(template)).collect();
        let mut own: BTreeMap<TaskId, Vec<Ball>> = BTreeMap::new();
        let mut sisters: Vec<Vec<Ball>> = vec![Vec::new(); TEMPLATES.len()];
        for solution in read_solutions(&self.solutions)?.0 {
            own.entry(solution.task).or_default().push(solution.ball);
            sisters[solution.task.template].push(solution.ball);
        }
        let total = self.rounds * tasks.len();
        let mut done = resume(&self.out)?;
        let mut file = OpenOptions::new().create(true).append(true).open(&self.out)?;
        let mut progress = Progress::new(Some(total as u64));
        progress.advance(done as u64, format!("{} balls", done * BALLS));
        while done < total {
            let block: Vec<Labels> = (done..total.min(done + BLOCK))
                .into_par_iter()
                .map(|line| {
                    let (round, task) = (line / tasks.len(), &tasks[line % tasks.len()]);
                    let own = own.get(&task.id).map_or(&[][..], Vec::as_slice);
                    Labels::draw(task, own, &sisters[task.id.template], BALLS, self.seed, round)
                })
                .collect();
            let mut lines = Vec::new();
            for labels in &block {
                serde_json::to_writer(&mut lines, labels)?;
                lines.push(b'\n');
            }
            file.write_all(&lines).with_context(|| format!("cannot write {}", self.out.display()))?;
            done += block.len();
            progress.advance(block.len() as u64, format!("{} balls", done * BALLS));
        }
        progress.finish(&format!("{} balls of {} tasks", done * BALLS, tasks.len()));
        Ok(())
    }
}

/// Cuts off a last line that is not whole, and counts the others.
fn resume(path: &Path) -> anyhow::Result<usize> {
    let Ok(file) = File::open(path) else {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).with_context(|| format!("cannot make the folder of {}", path.display()))?;
        }
        return Ok(0);
    };
    let (mut whole, mut kept) = (0, 0);
    for line in BufReader::new(file).split(b'\n') {
        let line = line?;
        if serde_json::from_slice::<Labels>(&line).is_err() {
            ensure!(whole > 0, "{} is no file of `pathlight label`: name another with --out", path.display());
            break;
        }
        (whole, kept) = (whole + 1, kept + line.len() as u64 + 1);
    }
    OpenOptions::new().write(true).open(path)?.set_len(kept)?;
    Ok(whole)
}
