//! `pathlight label`: balls with their outcome for all tasks, as JSON lines, to train a judge on.
//!
//! The first line holds the settings. Every other holds some balls of one task; round after round, every task gets
//! a line, so the number of lines says where a run that was cut off goes on. The balls follow from the settings
//! and the solutions alone.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use pathlight::benchmark::folds::{FOLDS, Fold, Setup};
use pathlight::dataset::labels::Labels;
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::{TEMPLATES, Template};
use pathlight::simulator;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::collect::read_solutions;
use super::digest;
use super::file_lock::hold;
use super::fold_args::setup;
use super::progress::Progress;

/// Balls of a task in a line.
pub const BALLS: usize = 64;

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

    /// Try balls on this template alone, like 00007
    #[arg(long, value_name = "TEMPLATE", value_parser = super::template)]
    template: Option<&'static Template>,

    /// Tasks of each template at most
    #[arg(long, value_name = "N", default_value_t = 100)]
    limit: usize,

    /// Use only the training tasks of one fold of this setup: only they are labelled, and only their solutions
    /// are drawn around
    #[arg(long, value_parser = setup, requires = "fold")]
    setup: Option<Setup>,

    /// The fold of --setup
    #[arg(long, requires = "setup", value_parser = clap::value_parser!(u8).range(0..i64::from(FOLDS)))]
    fold: Option<u8>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

/// The first line.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Settings {
    seed: u64,
    tasks: usize,
    first: TaskId,
    simulator: u32,
    /// SHA-256 of the file of solutions.
    solutions: String,
    /// Setup and fold if only the fold's training tasks were used; absent if all tasks were.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    training_tasks_of: Option<(Setup, u8)>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let templates = TEMPLATES.iter().filter(|all| self.template.is_none_or(|one| one.number == all.number));
        let training_tasks_of = self.setup.zip(self.fold);
        // Test tasks must not steer where balls are sampled, so their solutions are left out too.
        let allowed = training_tasks_of.map(|(setup, fold)| Fold::new(setup, fold).all_train());
        let allows = |id: TaskId| allowed.as_ref().is_none_or(|allowed| allowed.binary_search(&id).is_ok());
        let tasks: Vec<Task> =
            templates.flat_map(|template| Task::of(template).take(self.limit)).filter(|task| allows(task.id)).collect();
        let first = tasks.first().context("no task is left to label: choose another --template, --fold or --limit")?.id;
        let settings = Settings {
            seed: self.seed,
            tasks: tasks.len(),
            first,
            simulator: simulator::VERSION,
            solutions: digest(&self.solutions)?,
            training_tasks_of,
        };
        let mut own: BTreeMap<TaskId, Vec<Ball>> = BTreeMap::new();
        let mut sisters: Vec<Vec<Ball>> = vec![Vec::new(); TEMPLATES.len()];
        for solution in read_solutions(&self.solutions)?.solutions.into_iter().filter(|one| allows(one.task)) {
            own.entry(solution.task).or_default().push(solution.ball);
            sisters[solution.task.template].push(solution.ball);
        }
        let total = self.rounds * tasks.len();
        let mut file = hold(&self.out)?;
        let mut done = resume(&self.out, &settings)?;
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

/// Cuts off a last line that is not whole, and counts the others. A new file begins with the settings.
fn resume(path: &Path, settings: &Settings) -> anyhow::Result<usize> {
    let name = path.display();
    let file = File::open(path).with_context(|| format!("cannot read {name}"))?;
    if file.metadata()?.len() == 0 {
        fs::write(path, serde_json::to_string(settings)? + "\n").with_context(|| format!("cannot write {name}"))?;
        return Ok(0);
    }
    let mut lines = BufReader::new(file).split(b'\n');
    let first = lines.next().transpose()?.unwrap_or_default();
    match serde_json::from_slice::<Settings>(&first) {
        Ok(found) if found == *settings => {}
        Ok(found) => bail!("{name} was made with {found:?}, now it is {settings:?}: name another file with --out"),
        Err(_) => bail!("{name} is no file of `pathlight label`: name another with --out"),
    }
    let (mut whole, mut kept) = (0, first.len() as u64 + 1);
    for line in lines {
        let line = line?;
        if serde_json::from_slice::<Labels>(&line).is_err() {
            break;
        }
        (whole, kept) = (whole + 1, kept + line.len() as u64 + 1);
    }
    OpenOptions::new().write(true).open(path)?.set_len(kept)?;
    Ok(whole)
}

/// The balls in a file of `pathlight label`, line by line.
///
/// # Errors
/// If there is no such file, or another simulator has made it.
pub fn read_labels(path: &Path) -> anyhow::Result<impl Iterator<Item = Labels>> {
    let name = path.display();
    let file = File::open(path).with_context(|| format!("no balls in {name}: run `pathlight label` first"))?;
    let mut lines = BufReader::new(file).lines().map_while(Result::ok);
    let first = lines.next().unwrap_or_default();
    let Settings { simulator: version, .. } = settings(&first, path)?;
    ensure!(
        version == simulator::VERSION,
        "the balls are of simulator {version}, this is simulator {}: label them again",
        simulator::VERSION
    );
    // The last line may have been cut off with the run.
    Ok(lines.map_while(|line| serde_json::from_str(&line).ok()))
}

/// How many rounds a file of `pathlight label` holds; `None` if its last round is not whole.
///
/// # Errors
/// As `read_labels`.
pub fn rounds(path: &Path) -> anyhow::Result<Option<usize>> {
    let lines = read_labels(path)?.count();
    let mut first = String::new();
    BufReader::new(File::open(path)?).read_line(&mut first)?;
    let tasks = settings(&first, path)?.tasks;
    Ok(lines.is_multiple_of(tasks).then(|| lines / tasks))
}

fn settings(line: &str, path: &Path) -> anyhow::Result<Settings> {
    let settings = serde_json::from_str(line);
    settings.with_context(|| format!("{} is no file of `pathlight label`: name another with --labels", path.display()))
}
