//! `pathlight evaluate`: how well an agent does on a fold's test tasks, beside chance, as a table and as JSON.
//!
//! The simulator is called for the counted attempts alone: an agent proposes first, then its balls are tried
//! in order until one solves the task.

use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use clap::ValueEnum;
use pathlight::action::Ball;
use pathlight::auccess::{ATTEMPTS, auccess, share_within};
use pathlight::folds::Setup;
use pathlight::pathnet::Card;
use pathlight::proposer;
use pathlight::scene::Scene;
use pathlight::simulator::{self, outcome};
use pathlight::task::TaskId;
use pathlight::templates::TEMPLATES;
use rayon::prelude::*;
use serde::Serialize;

use super::progress::Progress;
use super::scenes::Scenes;
use super::weights::Weights;
use super::which::Which;

/// Measure an agent on the test tasks of a fold
#[derive(clap::Args)]
pub struct Args {
    /// Who plays; the random agent always plays too, for comparison
    #[arg(long, value_enum, default_value_t = Player::Model)]
    agent: Player,

    #[command(flatten)]
    which: Which,

    /// Play the dev tasks, to choose settings by, instead of the test tasks
    #[arg(long)]
    dev: bool,

    /// Tasks of each template to play at most
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    /// Seed of all that is drawn
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Write settings and the first solved attempt of every task to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    /// Let the model propose as in the paper, from its placement map, even if it has a judge
    #[arg(long)]
    without_judge: bool,

    #[command(flatten)]
    weights: Weights,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Player {
    Model,
    Random,
}

/// What was measured, and how.
#[derive(Serialize)]
struct Report {
    setup: Setup,
    fold: u8,
    tasks_of: &'static str,
    seed: u64,
    simulator: u32,
    /// The weights of the model, if it played.
    card: Option<Card>,
    agents: Vec<Score>,
}

#[derive(Serialize)]
struct Score {
    agent: &'static str,
    auccess: f64,
    solved_at_once: f64,
    solved_within_10: f64,
    solved_within_100: f64,
    /// The attempt that solved each task first, from 1; null if none of 100 did.
    first_solved: Vec<(TaskId, Option<usize>)>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let fold = self.which.tasks();
        let (tasks, tasks_of) = if self.dev { (fold.dev, "dev") } else { (fold.test, "test") };
        let tasks: Vec<TaskId> = tasks
            .chunk_by(|a, b| a.template == b.template)
            .flat_map(|sisters| sisters.iter().copied().take(self.limit.unwrap_or(usize::MAX)))
            .collect();
        let mut report = Report {
            setup: self.which.setup,
            fold: self.which.fold,
            tasks_of,
            seed: self.seed,
            simulator: simulator::VERSION,
            card: None,
            agents: Vec::new(),
        };
        if self.agent == Player::Model {
            let (mut nets, mut card) = self.weights.load(&self.which)?;
            if self.without_judge {
                (nets.judge, card.judge) = (None, None);
            }
            report.card = Some(card);
            let model = |task, scene: &Scene| proposer::model(&nets, task, scene, self.seed, ATTEMPTS);
            report.agents.push(score("model", model, &tasks)?);
        }
        let random = |task, scene: &Scene| proposer::random(task, scene, self.seed, ATTEMPTS);
        report.agents.push(score("random", random, &tasks)?);
        report.print(&tasks);
        if let Some(path) = &self.json {
            let json = serde_json::to_vec_pretty(&report)?;
            fs::write(path, json).with_context(|| format!("cannot write {}", path.display()))?;
        }
        Ok(())
    }
}

/// Lets an agent play tasks.
fn score(
    name: &'static str,
    propose: impl Fn(TaskId, &Scene) -> Vec<Ball> + Sync,
    tasks: &[TaskId],
) -> anyhow::Result<Score> {
    let scenes = Scenes::new();
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
        progress.advance(chunk.len() as u64, format!("tasks played by {name}"));
    }
    progress.finish(&format!("{} tasks played by {name}", tasks.len()));
    let firsts: Vec<_> = first_solved.iter().map(|&(_, first)| first).collect();
    Ok(Score {
        agent: name,
        auccess: auccess(&firsts),
        solved_at_once: share_within(&firsts, 1),
        solved_within_10: share_within(&firsts, 10),
        solved_within_100: share_within(&firsts, ATTEMPTS),
        first_solved,
    })
}

impl Report {
    fn print(&self, tasks: &[TaskId]) {
        let Report { setup, fold, tasks_of, seed, simulator, .. } = self;
        println!("{setup}, fold {fold}, {} {tasks_of} tasks, seed {seed}, simulator {simulator}", tasks.len());
        if let Some(card @ Card { samples, tasks, epochs, seed, .. }) = self.card.as_ref() {
            let judge =
                card.judge.as_ref().map(|judge| format!("; judge: {} balls, {} epochs", judge.balls, judge.epochs));
            println!(
                "model: {samples} solutions of {tasks} tasks, {epochs} epochs, seed {seed}{}",
                judge.unwrap_or_default()
            );
        }
        print!("{:30} {:>5}", "template", "tasks");
        for Score { agent, .. } in &self.agents {
            print!("  {:>15} {:>6} {:>6} {:>6}", format!("{agent}: auccess"), "1st", "<= 10", "<= 100");
        }
        println!();
        for sisters in tasks.chunk_by(|a, b| a.template == b.template) {
            let template = TEMPLATES[sisters[0].template];
            let of_template = |task: &TaskId| task.template == template.number;
            self.row(&format!("{:05} {}", template.number, template.name), of_template);
        }
        self.row("all", |_| true);
    }

    fn row(&self, name: &str, of: impl Fn(&TaskId) -> bool) {
        print!("{name:30}");
        for (column, score) in self.agents.iter().enumerate() {
            let firsts: Vec<_> =
                score.first_solved.iter().filter(|(task, _)| of(task)).map(|&(_, first)| first).collect();
            if column == 0 {
                print!(" {:>5}", firsts.len());
            }
            let [one, ten, hundred] = [1, 10, ATTEMPTS].map(|attempts| 100.0 * share_within(&firsts, attempts));
            print!("  {:>15.1} {one:>4.0} % {ten:>4.0} % {hundred:>4.0} %", auccess(&firsts));
        }
        println!();
    }
}
