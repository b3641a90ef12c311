//! `pathlight collect`: solutions of all 2,500 tasks, found by simulation, as JSON lines.
//!
//! The first line of the file holds the settings; then come the solutions, and a line that closes each round.
//! A run that was cut off goes on after the last closed round; with the same settings the file comes out the
//! same on any number of cores. The pictures that nets learn from follow from these lines (`samples`).

use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use pathlight::dataset::solutions::{Catch, Hunt, Solution};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::{TEMPLATES, Template};
use pathlight::simulator;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::file_lock::hold;
use super::progress::Progress;

/// Find balls that solve the tasks, by simulation, to train on
#[derive(clap::Args)]
pub struct Args {
    /// The file to write, or to go on with
    #[arg(long, default_value = "target/solutions.jsonl")]
    out: PathBuf,

    /// Solutions to find for each task
    #[arg(long, default_value_t = 10)]
    wanted: usize,

    /// Rounds in which all unfinished tasks are searched; in each, a task tries 32 balls
    #[arg(long, default_value_t = 200)]
    rounds: usize,

    /// Further rounds at most, for tasks of which no solution is known by then: as soon as they have one, they rest
    #[arg(long, value_name = "ROUNDS", default_value_t = 1500)]
    persist: usize,

    /// Search this template alone, like 00007
    #[arg(long, value_name = "TEMPLATE", value_parser = super::template)]
    template: Option<&'static Template>,

    /// Tasks of each template to search at most
    #[arg(long, value_name = "N", default_value_t = 100)]
    limit: usize,

    /// Begin with those solutions of another file, of an older simulator say, that solve their tasks here
    #[arg(long, value_name = "FILE")]
    from: Option<PathBuf>,

    /// Seed of all that is drawn
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

/// A line of the file.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Line {
    Settings(Settings),
    Solution(Solution),
    Round { round: usize, rollouts: usize },
}

#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Settings {
    seed: u64,
    wanted: usize,
    simulator: u32,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let settings = Settings { seed: self.seed, wanted: self.wanted, simulator: simulator::VERSION };
        let templates = TEMPLATES.iter().filter(|all| self.template.is_none_or(|one| one.number == all.number));
        let mut hunts: Vec<Hunt> =
            templates.flat_map(|template| Task::of(template).take(self.limit)).map(Hunt::new).collect();
        let mut file = hold(&self.out)?;
        let (first, mut rollouts) = resume(&self.out, &settings, &mut hunts)?;
        let known = |hunts: &[Hunt]| hunts.iter().map(|hunt| hunt.found.len()).sum::<usize>();
        let mut progress = Progress::new(Some((hunts.len() * self.wanted) as u64));
        progress.advance(known(&hunts) as u64, format!("round {first}"));
        for round in first..self.rounds + self.persist {
            let wanted = if round < self.rounds { self.wanted } else { self.wanted.min(1) };
            if hunts.iter().all(|hunt| hunt.found.len() >= wanted) {
                break;
            }
            // What the tasks of a template know together when the round begins.
            let mut shared: Vec<Vec<Ball>> = vec![Vec::new(); TEMPLATES.len()];
            for hunt in &hunts {
                shared[hunt.task.template].extend_from_slice(&hunt.found);
            }
            let catches: Vec<Catch> = match &self.from {
                Some(file) if round == 0 => self.take_over(file, &hunts)?,
                _ => hunts
                    .par_iter()
                    .map(|hunt| hunt.round(&shared[hunt.task.template], wanted, self.seed, round))
                    .collect(),
            };
            let mut lines = Vec::new();
            let before = known(&hunts);
            for (hunt, catch) in hunts.iter_mut().zip(catches) {
                for &ball in &catch.found {
                    write_line(&mut lines, &Line::Solution(Solution { task: hunt.task, ball }))?;
                }
                hunt.found.extend(catch.found);
                rollouts += catch.rollouts;
            }
            write_line(&mut lines, &Line::Round { round, rollouts })?;
            file.write_all(&lines).with_context(|| format!("cannot write {}", self.out.display()))?;
            let unsolved = hunts.iter().filter(|hunt| hunt.found.is_empty()).count();
            let so_far = format!(
                "round {round}: {} solutions, {unsolved} tasks without any, {rollouts} rollouts",
                known(&hunts)
            );
            progress.advance((known(&hunts) - before) as u64, so_far);
        }
        progress.finish(&format!("{} solutions of {} tasks, {rollouts} rollouts", known(&hunts), hunts.len()));
        report(&hunts, self.wanted);
        Ok(())
    }
}

impl Args {
    /// Tries the solutions of another file: a round of its own.
    fn take_over(&self, file: &Path, hunts: &[Hunt]) -> anyhow::Result<Vec<Catch>> {
        let mut solutions = read_solutions(file)?.solutions;
        solutions.sort_by_key(|solution| solution.task);
        let of = |task: TaskId| {
            let of_task = solutions.iter().filter(move |solution| solution.task == task);
            of_task.map(|solution| solution.ball).take(self.wanted)
        };
        Ok(hunts.par_iter().map(|hunt| hunt.retry(of(hunt.task))).collect())
    }
}

/// How many tasks have fewer solutions than wanted, template by template where some have none.
fn report(hunts: &[Hunt], wanted: usize) {
    let fewer = hunts.iter().filter(|hunt| hunt.found.len() < wanted).count();
    let none = hunts.iter().filter(|hunt| hunt.found.is_empty()).count();
    println!("{fewer} of {} tasks have fewer than {wanted} solutions, {none} have none", hunts.len());
    for sisters in hunts.chunk_by(|a, b| a.task.template == b.task.template) {
        let none: Vec<String> = sisters.iter().filter(|h| h.found.is_empty()).map(|h| h.task.to_string()).collect();
        if let Some(first) = none.first() {
            println!("{:05}: {} without any, the first is {first}", sisters[0].task.template, none.len());
        }
    }
}

/// Takes over what the file holds up to its last closed round, and cuts off what came after. A new file begins
/// with the settings. Gives the round to go on with and the rollouts so far.
fn resume(path: &Path, settings: &Settings, hunts: &mut [Hunt]) -> anyhow::Result<(usize, usize)> {
    let name = path.display();
    let file = File::open(path).with_context(|| format!("cannot read {name}"))?;
    if file.metadata()?.len() == 0 {
        let mut lines = Vec::new();
        write_line(&mut lines, settings)?;
        fs::write(path, lines).with_context(|| format!("cannot write {name}"))?;
        return Ok((0, 0));
    }
    let (mut next, mut rollouts, mut kept, mut read) = (0, 0, 0, 0);
    let mut open: Vec<Solution> = Vec::new();
    for (number, line) in (1..).zip(BufReader::new(file).split(b'\n')) {
        let line = line?;
        read += line.len() as u64 + 1;
        // The last line may have been cut off with the run.
        let Ok(line) = serde_json::from_slice(&line) else { break };
        match line {
            Line::Settings(found) if found == *settings => kept = read,
            Line::Settings(found) => {
                bail!("{name} was collected with {found:?}, now it is {settings:?}: name another file with --out")
            }
            _ if number == 1 => bail!("{name} is no file of `pathlight collect`: name another with --out"),
            Line::Solution(solution) => open.push(solution),
            Line::Round { round, rollouts: total } => {
                (next, rollouts, kept) = (round + 1, total, read);
                for Solution { task, ball } in open.drain(..) {
                    let hunt = hunts.binary_search_by_key(&task, |hunt| hunt.task);
                    let hunt =
                        hunt.map_err(|_| anyhow::anyhow!("{name} names {task}, which this run does not search"))?;
                    hunts[hunt].found.push(ball);
                }
            }
        }
    }
    if kept == 0 {
        bail!("{name} is no file of `pathlight collect`: name another with --out");
    }
    OpenOptions::new().write(true).open(path)?.set_len(kept)?;
    Ok((next, rollouts))
}

/// What a file of `pathlight collect` holds.
pub struct Collected {
    pub solutions: Vec<Solution>,
    /// The version of the simulator that found them.
    pub simulator: u32,
    /// Balls tried for it.
    pub rollouts: usize,
}

/// Reads a file of `pathlight collect`.
///
/// # Errors
/// Says what is wrong with the file.
pub fn read_solutions(path: &Path) -> anyhow::Result<Collected> {
    let name = path.display();
    let file = File::open(path).with_context(|| format!("no solutions in {name}: run `pathlight collect` first"))?;
    let (mut solutions, mut simulator, mut rollouts) = (Vec::new(), None, 0);
    for line in BufReader::new(file).lines() {
        match serde_json::from_str(&line?) {
            Ok(Line::Settings(settings)) => simulator = Some(settings.simulator),
            Ok(Line::Solution(solution)) => solutions.push(solution),
            Ok(Line::Round { rollouts: total, .. }) => rollouts = total,
            // The last line may have been cut off with the run.
            Err(_) => break,
        }
    }
    let simulator = simulator.with_context(|| format!("{name} is no file of `pathlight collect`"))?;
    Ok(Collected { solutions, simulator, rollouts })
}

fn write_line(lines: &mut Vec<u8>, line: &impl Serialize) -> anyhow::Result<()> {
    serde_json::to_writer(&mut *lines, line)?;
    lines.push(b'\n');
    Ok(())
}
