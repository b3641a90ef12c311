//! Measures the auccess of agents, and of the random agent for comparison, on the test tasks of a fold.
//!
//! Only counted attempts are simulated: an agent proposes one ball at a time and observes its outcome, until a ball
//! solves the task.

use std::path::PathBuf;

use pathlight::agents::agent_name::{AgentName, Loaded};
use pathlight::agents::{self, Agent};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::weights_file::{ModelFile, read_dqn};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::session::turn::Turn;
use pathlight::simulator::Engine;
use rayon::prelude::*;

use super::agents::row;
use super::report::{Order, Player, Report, Score};
use super::task_set::TaskSet;
use super::with_memory;
use crate::progress::Progress;

/// What to measure.
#[derive(Default)]
pub struct Settings {
    /// Agents to measure. If empty, all that the weights support, except those with `on_request`; DQN only if `dqn` is
    /// set. The random agent is always measured too.
    pub agents: Vec<AgentName>,
    pub fold: FoldId,
    pub tasks: TaskSet,
    /// Use only the first N of these tasks per template.
    pub limit: Option<u16>,
    /// Seed of all random draws.
    pub seed: u64,
    /// Also measure agents that support a memory with one, in each of these orders of tasks.
    pub memory: Vec<Order>,
    pub engine: Engine,
    /// Weights of the model; `None` means the shipped ones.
    pub weights: Option<PathBuf>,
    /// Weights of DQN; `None` means those of the default folder, if the agent is named.
    pub dqn: Option<PathBuf>,
}

impl Settings {
    /// Measures the agents.
    ///
    /// # Errors
    /// If the weights cannot be used.
    pub fn measure(&self, progress: &mut dyn Progress) -> anyhow::Result<Report> {
        let tasks = self.tasks.tasks(self.fold, self.limit);
        let mut report = Report {
            setup: self.fold.setup,
            fold: self.fold.fold,
            tasks_of: self.tasks,
            limit: self.limit,
            seed: self.seed,
            engine: self.engine,
            simulator: self.engine.version(),
            agents_version: agents::VERSION,
            card: None,
            dqn: None,
            agents: Vec::new(),
            made_by: Vec::new(),
            core_minutes: None,
        };
        let (mut nets, mut of_model) = (None, Vec::new());
        if AgentName::ALL.into_iter().any(|agent| agent.is_of_model() && self.measures(agent)) {
            let model = ModelFile::read(self.weights.as_deref(), self.fold)?;
            of_model = self.playable(&model)?;
            let mut card = model.card;
            if !self.measures(AgentName::Success) {
                card.success = None;
            }
            (report.card, nets) = (Some(card), Some(model.nets));
        }
        let mut dqn = None;
        if self.agents.contains(&AgentName::Dqn) || self.dqn.is_some() {
            let (loaded, card) = read_dqn(self.dqn.as_deref(), self.fold)?;
            self.tasks.check(card.without_dev, "dqn")?;
            report.dqn = Some(card);
            dqn = Some(loaded);
        }
        let loaded = Loaded { nets: nets.as_ref(), dqn: dqn.as_ref() };
        for agent in AgentName::ALL {
            let is_measured = match agent {
                AgentName::Random => true,
                AgentName::Listed => self.measures(agent),
                AgentName::Dqn => loaded.dqn.is_some(),
                agent => of_model.contains(&agent),
            };
            if is_measured {
                let start =
                    |task: TaskId, scene: &Scene| agent.start(loaded, scene, task.seed(self.seed), MAX_ATTEMPTS);
                report.agents.push(score(agent, start, self.engine, &tasks, progress)?);
            }
            if is_measured && agent.check_remembers().is_ok() {
                let players = self.memory.iter().map(|&order| Player { agent, memory: Some(order) });
                report.agents.extend(with_memory::scores(
                    &players.collect::<Vec<_>>(),
                    loaded,
                    &tasks,
                    self.seed,
                    progress,
                )?);
            }
        }
        Ok(report)
    }

    /// Returns the agents to measure that a model has the nets for, none of which has seen the tasks. If agents are
    /// named, it must have the nets for all of them.
    fn playable(&self, model: &ModelFile) -> anyhow::Result<Vec<AgentName>> {
        let (mut playable, mut refused) = (Vec::new(), Ok(()));
        for agent in AgentName::ALL.into_iter().filter(|&agent| agent.is_of_model() && self.measures(agent)) {
            match model.check(agent, self.fold) {
                Ok(()) => {
                    self.tasks.check_model(agent, &model.card)?;
                    playable.push(agent);
                }
                error => refused = refused.and(error),
            }
        }
        if playable.is_empty() || !self.agents.is_empty() {
            refused?;
        }
        Ok(playable)
    }

    /// Whether the settings ask for an agent.
    fn measures(&self, agent: AgentName) -> bool {
        if self.agents.is_empty() { !row(agent).on_request } else { self.agents.contains(&agent) }
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
            Ok(Turn::in_engine(scene, agent, engine).first_solved().expect("agents propose valid balls"))
        });
        first_solved.extend(played.collect::<anyhow::Result<Vec<_>>>()?);
        progress.advance(chunk.len() as u64, format!("tasks attempted by {agent}"));
    }
    progress.finish(&format!("{} tasks attempted by {agent}", tasks.len()));
    Ok(Score::new(agent, first_solved))
}
