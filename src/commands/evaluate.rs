//! `pathlight evaluate`: auccess of agents on a fold's test tasks, beside the random agent, as a table and as JSON.
//!
//! Only counted attempts are simulated: an agent proposes one ball at a time and observes what became of it, until one
//! solves the task.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::{fmt, io};

use anyhow::ensure;
use pathlight::agents::{self, Agent};
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::Setup;
use pathlight::nets::{Card, DqnCard};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::session::turn::Turn;
use pathlight::simulator::Engine;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::agent_name::{AgentName, Loaded};
use super::dqn_args::DqnArgs;
use super::engine_arg::EngineArg;
use super::fold_args::{FoldArgs, first_of_each_template};
use super::json_file;
use super::model_args::ModelArgs;
use super::progress::Progress;

/// Measure agents on the test tasks of a fold
#[derive(clap::Args)]
pub struct Args {
    /// Agent to measure; can be repeated. The random agent is always measured too [default: all that the weights allow
    /// but online-by-balls; DQN with --dqn]
    #[arg(long = "agent", value_enum)]
    pub agents: Vec<AgentName>,

    #[command(flatten)]
    pub fold: FoldArgs,

    /// Use the dev tasks, to choose settings on, instead of the test tasks
    #[arg(long)]
    pub dev: bool,

    /// Use at most the first N of these tasks of each template
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub limit: Option<u16>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    pub seed: u64,

    /// Write the settings and the first solving attempt of every task to this file, as JSON
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,

    #[command(flatten)]
    pub engine: EngineArg,

    #[command(flatten)]
    pub model: ModelArgs,

    #[command(flatten)]
    pub dqn: DqnArgs,
}

/// What was measured, and how. The `--json` file.
#[derive(Serialize, Deserialize)]
pub struct Report {
    pub setup: Setup,
    pub fold: u8,
    /// `test` or `dev`.
    pub tasks_of: String,
    pub seed: u64,
    /// What simulated the attempts; absent if that is the first engine.
    #[serde(default, skip_serializing_if = "Engine::is_first")]
    pub engine: Engine,
    /// The version of the engine.
    pub simulator: u32,
    /// `agents::VERSION`; 0 in a file that does not record it.
    #[serde(default)]
    pub agents_version: u32,
    /// How the model was trained, if it was measured.
    pub card: Option<Card>,
    /// How DQN was trained, if it was measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dqn: Option<DqnCard>,
    pub agents: Vec<Score>,
}

/// The results of an agent.
#[derive(Serialize, Deserialize)]
pub struct Score {
    pub agent: AgentName,
    /// 0..=100
    pub auccess: f64,
    /// Fraction of the tasks solved at the first attempt.
    pub solved_at_once: f64,
    pub solved_within_10: f64,
    pub solved_within_100: f64,
    /// The first attempt that solved each task, counted from 1; null if none did.
    pub first_solved: Vec<(TaskId, Option<usize>)>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let report = self.measure()?;
        // The file comes first, so that a closed pipe does not lose it.
        if let Some(path) = &self.json {
            json_file::write(path, &report)?;
        }
        io::stdout().write_all(report.table()?.as_bytes())?;
        Ok(())
    }

    /// Measures the agents.
    ///
    /// # Errors
    /// If the weights cannot be used for it.
    pub fn measure(&self) -> anyhow::Result<Report> {
        let EngineArg { engine } = self.engine;
        let fold = self.fold.tasks();
        let (tasks, tasks_of) = if self.dev { (fold.dev, "dev") } else { (fold.test, "test") };
        let tasks = first_of_each_template(&tasks, self.limit);
        let mut report = Report {
            setup: self.fold.setup,
            fold: self.fold.fold,
            tasks_of: tasks_of.to_string(),
            seed: self.seed,
            engine,
            simulator: engine.version(),
            agents_version: agents::VERSION,
            card: None,
            dqn: None,
            agents: Vec::new(),
        };
        let measures = |agent| match self.agents.as_slice() {
            [] => agent != AgentName::OnlineByBalls,
            named => named.contains(&agent),
        };
        let (mut nets, mut dqn) = (None, None);
        if AgentName::MODEL.into_iter().any(measures) {
            let (loaded, mut card) = self.model.load(&self.fold)?;
            self.check_dev(card.without_dev, "train")?;
            for agent in &self.agents {
                agent.check(&loaded)?;
            }
            if !measures(AgentName::Judge) {
                card.judge = None;
            }
            report.card = Some(card);
            nets = Some(loaded);
        }
        if self.agents.contains(&AgentName::Dqn) || self.dqn.dqn.is_some() {
            let (loaded, card) = self.dqn.load(&self.fold)?;
            self.check_dev(card.without_dev, "train-dqn")?;
            report.dqn = Some(card);
            dqn = Some(loaded);
        }
        let loaded = Loaded { nets: nets.as_ref(), dqn: dqn.as_ref() };
        let of_model =
            |agent: &AgentName| measures(*agent) && loaded.nets.is_some_and(|nets| agent.check(nets).is_ok());
        let dqn = loaded.dqn.map(|_| AgentName::Dqn);
        for agent in AgentName::MODEL.into_iter().filter(of_model).chain(dqn).chain([AgentName::Random]) {
            let start = |task: TaskId, scene: &Scene| agent.start(loaded, scene, task.seed(self.seed), MAX_ATTEMPTS);
            report.agents.push(score(agent, start, engine, &tasks)?);
        }
        Ok(report)
    }

    /// Checks that the dev tasks, if they are attempted, were not trained on.
    fn check_dev(&self, without_dev: bool, command: &str) -> anyhow::Result<()> {
        ensure!(
            !self.dev || without_dev,
            "these weights were trained on the dev tasks too, so --dev would measure nothing new: train with \
             `pathlight {command} --without-dev`"
        );
        Ok(())
    }
}

/// Measures an agent on some tasks in an engine.
fn score(
    agent: AgentName,
    start: impl Fn(TaskId, &Scene) -> Box<dyn Agent> + Sync,
    engine: Engine,
    tasks: &[TaskId],
) -> anyhow::Result<Score> {
    let mut progress = Progress::new(Some(tasks.len() as u64));
    let mut first_solved = Vec::with_capacity(tasks.len());
    for chunk in tasks.chunks(20) {
        let played = chunk.par_iter().map(|&task| {
            let scene = Task::load(task)?.scene;
            let agent = start(task, &scene);
            Ok((task, Turn::in_engine(scene, agent, engine).first_solved().expect("agents propose valid balls")))
        });
        first_solved.extend(played.collect::<anyhow::Result<Vec<_>>>()?);
        progress.advance(chunk.len() as u64, format!("tasks attempted by {agent}"));
    }
    progress.finish(&format!("{} tasks attempted by {agent}", tasks.len()));
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
    /// The results as a table for people: a row per template and one for all.
    pub fn table(&self) -> Result<String, fmt::Error> {
        // All agents attempt the same tasks.
        let attempted = self.agents.first().map_or(&[][..], |score| &score.first_solved);
        let tasks: Vec<TaskId> = attempted.iter().map(|&(task, _)| task).collect();
        let Report { setup, fold, tasks_of, seed, engine, simulator, .. } = self;
        let mut text = String::new();
        write!(text, "{setup}, fold {fold}, {} {tasks_of} tasks, seed {seed}, ", tasks.len())?;
        if !engine.is_first() {
            write!(text, "engine {engine}, ")?;
        }
        writeln!(text, "simulator {simulator}")?;
        if let Some(card @ Card { samples, tasks, epochs, seed, .. }) = self.card.as_ref() {
            write!(text, "model: {samples} solutions of {tasks} tasks, {epochs} epochs, seed {seed}")?;
            if let Some(judge) = &card.judge {
                write!(text, "; judge: {} balls, {} epochs", judge.balls, judge.epochs)?;
            }
            if let Some(dynamics) = &card.dynamics {
                write!(text, "; dynamics net: {} balls, {} epochs", dynamics.balls, dynamics.epochs)?;
            }
            writeln!(text)?;
        }
        if let Some(DqnCard { balls, epochs, seed, .. }) = &self.dqn {
            writeln!(text, "DQN: {balls} balls, {epochs} epochs, seed {seed}")?;
        }
        write!(text, "{:30} {:>5}", "template", "tasks")?;
        for Score { agent, .. } in &self.agents {
            write!(text, "  {:>15} {:>6} {:>6} {:>6}", format!("{agent}: auccess"), "1st", "<= 10", "<= 100")?;
        }
        writeln!(text)?;
        for of_template in tasks.chunk_by(|a, b| a.template == b.template) {
            let template = TEMPLATES[of_template[0].template];
            let name = format!("{:05} {}", template.number, template.name);
            self.row(&mut text, &name, |task| task.template == template.number)?;
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
