//! Auccess of agents on a fold's test tasks, beside the random agent, as a table and as JSON.
//!
//! Only counted attempts are simulated: an agent proposes one ball at a time and observes what became of it, until one
//! solves the task.

use std::fmt::{self, Write as _};
use std::path::PathBuf;

use anyhow::ensure;
use pathlight::agents::agent_name::{AgentName, Loaded};
use pathlight::agents::{self, Agent};
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::nets::{Card, DqnCard};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::session::turn::Turn;
use pathlight::simulator::Engine;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::agents::{Weights, row};
use super::task_set::TaskSet;
use crate::files::weights_file::{load_dqn, load_nets};
use crate::progress::Progress;

/// What to measure.
#[derive(Default)]
pub struct Settings {
    /// If empty, all agents that the weights allow, except those with `on_request`; DQN only if `dqn` is set. The
    /// random agent is always measured too.
    pub agents: Vec<AgentName>,
    pub fold: FoldId,
    pub tasks: TaskSet,
    /// Use only the first N of these tasks of each template.
    pub limit: Option<u16>,
    /// Seed of all random draws.
    pub seed: u64,
    pub engine: Engine,
    /// Weights of the model; `None` are the shipped ones.
    pub weights: Option<PathBuf>,
    /// Weights of DQN; `None` are those of the default folder, if the agent is named.
    pub dqn: Option<PathBuf>,
}

/// What was measured, and how. The `--json` file.
#[derive(Serialize, Deserialize)]
pub struct Report {
    pub setup: Setup,
    pub fold: u8,
    pub tasks_of: TaskSet,
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

/// Formats auccess, and the percentages solved at the first attempt, within 10 and within 100, as a cell of Markdown.
pub fn score_cell([auccess, first, ten, hundred]: [f64; 4]) -> String {
    format!("**{auccess:.1}** {first:.0} / {ten:.0} / {hundred:.0} %")
}

impl Settings {
    /// Measures the agents.
    ///
    /// # Errors
    /// If the weights cannot be used for it.
    pub fn measure(&self, progress: &mut dyn Progress) -> anyhow::Result<Report> {
        let tasks = self.tasks.tasks(self.fold, self.limit);
        let mut report = Report {
            setup: self.fold.setup,
            fold: self.fold.fold,
            tasks_of: self.tasks,
            seed: self.seed,
            engine: self.engine,
            simulator: self.engine.version(),
            agents_version: agents::VERSION,
            card: None,
            dqn: None,
            agents: Vec::new(),
        };
        let mut nets = None;
        if AgentName::ALL.into_iter().any(|agent| agent.is_of_model() && self.measures(agent)) {
            let (loaded, mut card) = load_nets(self.weights.as_deref(), self.fold)?;
            for agent in AgentName::ALL.into_iter().filter(|&agent| self.measures(agent)) {
                match row(agent).weights {
                    Weights::Dynamics => self.tasks.check_dynamics(&card)?,
                    Weights::Success => self.tasks.check(card.without_dev, "paths")?,
                    Weights::Dqn | Weights::None => {}
                }
            }
            for agent in &self.agents {
                agent.check(&loaded)?;
            }
            if !self.measures(AgentName::Success) {
                card.success = None;
            }
            report.card = Some(card);
            nets = Some(loaded);
        }
        let mut dqn = None;
        if self.agents.contains(&AgentName::Dqn) || self.dqn.is_some() {
            let (loaded, card) = load_dqn(self.dqn.as_deref(), self.fold)?;
            self.tasks.check(card.without_dev, "dqn")?;
            report.dqn = Some(card);
            dqn = Some(loaded);
        }
        for &agent in &self.agents {
            ensure!(
                self.may_measure(agent),
                "{agent} is of nets that were trained on some of the tasks, so --all-tasks would not measure what is \
                 new to them: name other agents"
            );
        }
        let loaded = Loaded { nets: nets.as_ref(), dqn: dqn.as_ref() };
        for agent in AgentName::ALL {
            let is_measured = match agent {
                AgentName::Random => true,
                AgentName::Dqn => loaded.dqn.is_some(),
                of_model => self.measures(of_model) && loaded.nets.is_some_and(|nets| of_model.check(nets).is_ok()),
            };
            if is_measured {
                let start =
                    |task: TaskId, scene: &Scene| agent.start(loaded, scene, task.seed(self.seed), MAX_ATTEMPTS);
                report.agents.push(score(agent, start, self.engine, &tasks, progress)?);
            }
        }
        Ok(report)
    }

    /// Whether an agent of a model is asked for.
    fn measures(&self, agent: AgentName) -> bool {
        if self.agents.is_empty() {
            !row(agent).on_request && self.may_measure(agent)
        } else {
            self.agents.contains(&agent)
        }
    }

    /// Whether the nets of an agent may be new to the tasks: the dynamics net alone can be trained without any.
    fn may_measure(&self, agent: AgentName) -> bool {
        self.tasks != TaskSet::All || matches!(row(agent).weights, Weights::Dynamics | Weights::None)
    }
}

/// Measures an agent on some tasks in an engine.
fn score(
    agent: AgentName,
    start: impl Fn(TaskId, &Scene) -> Box<dyn Agent> + Sync,
    engine: Engine,
    tasks: &[TaskId],
    progress: &mut dyn Progress,
) -> anyhow::Result<Score> {
    progress.begin(tasks.len() as u64);
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
    Ok(Score::new(agent, first_solved))
}

impl Score {
    fn new(agent: AgentName, first_solved: Vec<(TaskId, Option<usize>)>) -> Score {
        let firsts: Vec<_> = first_solved.iter().map(|&(_, first)| first).collect();
        Score {
            agent,
            auccess: auccess(&firsts),
            solved_at_once: solved_within(&firsts, 1),
            solved_within_10: solved_within(&firsts, 10),
            solved_within_100: solved_within(&firsts, MAX_ATTEMPTS),
            first_solved,
        }
    }
}

impl Report {
    /// The part of a report on all tasks that is on the test tasks of a fold.
    pub fn on_fold(&self, FoldId { setup, fold }: FoldId) -> Report {
        let tests = FoldId { setup, fold }.tasks().test;
        let on_tests = |score: &Score| {
            let of_tests = score.first_solved.iter().filter(|(task, _)| tests.binary_search(task).is_ok());
            Score::new(score.agent, of_tests.copied().collect())
        };
        let agents = self.agents.iter().map(on_tests).collect();
        Report { setup, fold, tasks_of: TaskSet::Test, card: self.card.clone(), dqn: self.dqn.clone(), agents, ..*self }
    }

    /// The first solving attempts of an agent, on all tasks or those of a template; empty if it was not measured.
    pub fn first_solved(&self, agent: AgentName, template: Option<usize>) -> Vec<Option<usize>> {
        let score = self.agents.iter().find(|score| score.agent == agent);
        let all = score.into_iter().flat_map(|score| &score.first_solved);
        all.filter(|(task, _)| template.is_none_or(|number| task.template == number)).map(|&(_, first)| first).collect()
    }

    /// Auccess, and the percentages of tasks solved at the first attempt, within 10 and within 100; `None` if the agent
    /// was not measured.
    pub fn score(&self, agent: AgentName) -> Option<[f64; 4]> {
        let firsts = self.first_solved(agent, None);
        let [first, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved_within(&firsts, attempts));
        (!firsts.is_empty()).then(|| [auccess(&firsts), first, ten, hundred])
    }

    /// The results as a table for people: a row per template and one for all.
    pub fn table(&self) -> Result<String, fmt::Error> {
        // All agents attempt the same tasks.
        let attempted = self.agents.first().map_or(&[][..], |score| &score.first_solved);
        let tasks: Vec<TaskId> = attempted.iter().map(|&(task, _)| task).collect();
        let &Report { setup, fold, tasks_of, seed, engine, simulator, .. } = self;
        let mut text = String::new();
        write!(text, "{}, seed {seed}, ", tasks_of.heading(FoldId { setup, fold }, tasks.len()))?;
        if !engine.is_first() {
            write!(text, "engine {engine}, ")?;
        }
        writeln!(text, "simulator {simulator}")?;
        if let Some(card @ Card { samples, tasks, epochs, seed, .. }) = self.card.as_ref() {
            write!(text, "model: {samples} solutions of {tasks} tasks, {epochs} epochs, seed {seed}")?;
            if let Some(success) = &card.success {
                write!(text, "; success net: {} balls, {} epochs", success.balls, success.epochs)?;
            }
            if let Some(dynamics) = &card.dynamics {
                write!(text, "; dynamics net: {} balls, {} epochs", dynamics.balls, dynamics.epochs)?;
                let scenes = [
                    (dynamics.blends, "blends"),
                    (dynamics.unlisted, "unlisted tasks"),
                    (dynamics.random_scenes, "random scenes"),
                ];
                for (count, of) in scenes.into_iter().filter(|(count, _)| *count > 0) {
                    write!(text, ", {count} {of}")?;
                }
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
            let [first, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved_within(&firsts, attempts));
            write!(text, "  {:>15.1} {first:>4.0} % {ten:>4.0} % {hundred:>4.0} %", auccess(&firsts))?;
        }
        writeln!(text)
    }
}
