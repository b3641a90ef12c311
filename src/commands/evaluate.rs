//! `pathlight evaluate`: how well agents do on a fold's test tasks, beside chance, as a table and as JSON.
//!
//! The simulator is called for the counted attempts alone: an agent proposes first, then its balls are tried
//! in order until one solves the task.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::{fmt, fs, io};

use anyhow::{Context, ensure};
use clap::ValueEnum;
use pathlight::agents;
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::Setup;
use pathlight::nets::{Card, PathNet};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{self, outcome};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::fold_args::FoldArgs;
use super::model_args::ModelArgs;
use super::progress::Progress;
use super::scene_cache::SceneCache;

/// Measure agents on the test tasks of a fold
#[derive(clap::Args)]
pub struct Args {
    /// Who plays; can be given several times, and the random agent always plays too [default: all that the weights allow]
    #[arg(long = "agent", value_enum)]
    agents: Vec<Agent>,

    #[command(flatten)]
    which: FoldArgs,

    /// Play the dev tasks, to choose settings by, instead of the test tasks
    #[arg(long)]
    dev: bool,

    /// Tasks of each template to play at most
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    limit: Option<u16>,

    /// Seed of all that is drawn
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Write settings and the first solved attempt of every task to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    #[command(flatten)]
    weights: ModelArgs,
}

/// Who proposes balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Agent {
    /// The model, its judge ordering the balls
    Judge,
    /// The model without a judge: balls from its placement map, as in the paper
    Paper,
    /// Chance: uniform balls
    Random,
}

impl fmt::Display for Agent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Agent::Judge => "judge",
            Agent::Paper => "paper",
            Agent::Random => "random",
        })
    }
}

/// What was measured, and how.
#[derive(Serialize, Deserialize)]
pub struct Report {
    pub setup: Setup,
    pub fold: u8,
    /// `test` or `dev`.
    pub tasks_of: String,
    pub seed: u64,
    pub simulator: u32,
    /// The weights of the model, if it played.
    pub card: Option<Card>,
    pub agents: Vec<Score>,
}

/// How an agent did.
#[derive(Serialize, Deserialize)]
pub struct Score {
    pub agent: Agent,
    pub auccess: f64,
    pub solved_at_once: f64,
    pub solved_within_10: f64,
    pub solved_within_100: f64,
    /// The attempt that solved each task first, from 1; null if none of 100 did.
    pub first_solved: Vec<(TaskId, Option<usize>)>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let fold = self.which.tasks();
        let (tasks, tasks_of) = if self.dev { (fold.dev, "dev") } else { (fold.test, "test") };
        let tasks: Vec<TaskId> = tasks
            .chunk_by(|a, b| a.template == b.template)
            .flat_map(|sisters| sisters.iter().copied().take(self.limit.map_or(usize::MAX, usize::from)))
            .collect();
        let mut report = Report {
            setup: self.which.setup,
            fold: self.which.fold,
            tasks_of: tasks_of.to_string(),
            seed: self.seed,
            simulator: simulator::VERSION,
            card: None,
            agents: Vec::new(),
        };
        let plays = |agent| self.agents.is_empty() || self.agents.contains(&agent);
        if plays(Agent::Judge) || plays(Agent::Paper) {
            let (mut nets, mut card) = self.weights.load(&self.which)?;
            ensure!(
                !self.dev || card.without_dev,
                "these weights were trained on the dev tasks too, so --dev would measure nothing new: train with \
                 `pathlight train --without-dev`"
            );
            ensure!(
                nets.judge.is_some() || !self.agents.contains(&Agent::Judge),
                "the weights have no judge: train one with `pathlight train-judge`, or leave --agent judge out"
            );
            if !plays(Agent::Judge) {
                card.judge = None;
            }
            report.card = Some(card);
            let model = |nets: &PathNet, task, scene: &Scene| {
                let proposals = agents::propose(nets, task, scene, self.seed, MAX_ATTEMPTS);
                proposals.into_iter().map(|proposal| proposal.ball).collect()
            };
            if nets.judge.is_some() && plays(Agent::Judge) {
                report.agents.push(score(Agent::Judge, |task, scene| model(&nets, task, scene), &tasks)?);
            }
            nets.judge = None;
            if plays(Agent::Paper) {
                report.agents.push(score(Agent::Paper, |task, scene| model(&nets, task, scene), &tasks)?);
            }
        }
        let random = |task, scene: &Scene| agents::random(task, scene, self.seed, MAX_ATTEMPTS);
        report.agents.push(score(Agent::Random, random, &tasks)?);
        // The file first: who reads the table may stop reading.
        if let Some(path) = &self.json {
            let json = serde_json::to_vec(&report)?;
            fs::write(path, json).with_context(|| format!("cannot write {}", path.display()))?;
        }
        io::stdout().write_all(report.table(&tasks)?.as_bytes())?;
        Ok(())
    }
}

/// Lets an agent play tasks.
fn score(
    agent: Agent,
    propose: impl Fn(TaskId, &Scene) -> Vec<Ball> + Sync,
    tasks: &[TaskId],
) -> anyhow::Result<Score> {
    let scenes = SceneCache::new();
    let mut progress = Progress::new(Some(tasks.len() as u64));
    let mut first_solved = Vec::with_capacity(tasks.len());
    for chunk in tasks.chunks(20) {
        let played = chunk.par_iter().map(|&task| {
            let scene = scenes.get(task)?;
            let balls = propose(task, scene);
            let solves = |&ball| outcome(scene, Some(ball)).expect("agents propose valid balls").solved;
            Ok((task, balls.iter().position(solves).map(|index| index + 1)))
        });
        first_solved.extend(played.collect::<anyhow::Result<Vec<_>>>()?);
        progress.advance(chunk.len() as u64, format!("tasks played by {agent}"));
    }
    progress.finish(&format!("{} tasks played by {agent}", tasks.len()));
    let firsts: Vec<_> = first_solved.iter().map(|&(_, first)| first).collect();
    Ok(Score {
        agent,
        auccess: auccess(&firsts),
        solved_at_once: solved_within(&firsts, 1),
        solved_within_10: solved_within(&firsts, 10),
        solved_within_100: solved_within(&firsts, MAX_ATTEMPTS),
        first_solved,
    })
}

impl Report {
    /// What was measured, for people.
    fn table(&self, tasks: &[TaskId]) -> Result<String, fmt::Error> {
        let Report { setup, fold, tasks_of, seed, simulator, .. } = self;
        let mut text = String::new();
        writeln!(text, "{setup}, fold {fold}, {} {tasks_of} tasks, seed {seed}, simulator {simulator}", tasks.len())?;
        if let Some(card @ Card { samples, tasks, epochs, seed, .. }) = self.card.as_ref() {
            write!(text, "model: {samples} solutions of {tasks} tasks, {epochs} epochs, seed {seed}")?;
            if let Some(judge) = &card.judge {
                write!(text, "; judge: {} balls, {} epochs", judge.balls, judge.epochs)?;
            }
            writeln!(text)?;
        }
        write!(text, "{:30} {:>5}", "template", "tasks")?;
        for Score { agent, .. } in &self.agents {
            write!(text, "  {:>15} {:>6} {:>6} {:>6}", format!("{agent}: auccess"), "1st", "<= 10", "<= 100")?;
        }
        writeln!(text)?;
        for sisters in tasks.chunk_by(|a, b| a.template == b.template) {
            let template = TEMPLATES[sisters[0].template];
            let of_template = |task: &TaskId| task.template == template.number;
            self.row(&mut text, &format!("{:05} {}", template.number, template.name), of_template)?;
        }
        self.row(&mut text, "all", |_| true)?;
        Ok(text)
    }

    fn row(&self, text: &mut String, name: &str, of: impl Fn(&TaskId) -> bool) -> fmt::Result {
        write!(text, "{name:30}")?;
        for (column, score) in self.agents.iter().enumerate() {
            let firsts: Vec<_> =
                score.first_solved.iter().filter(|(task, _)| of(task)).map(|&(_, first)| first).collect();
            if column == 0 {
                write!(text, " {:>5}", firsts.len())?;
            }
            let [one, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved_within(&firsts, attempts));
            write!(text, "  {:>15.1} {one:>4.0} % {ten:>4.0} % {hundred:>4.0} %", auccess(&firsts))?;
        }
        writeln!(text)
    }
}
