//! Auccess of agents that carry what attempts taught from task to task, as PHYRE's DQN-O does (Bakhtin et al. 2019):
//! they meet the tasks of a fold one after the other, and are never reset. This differs from `evaluate`, whose agents
//! forget every task, so the results have files and tables of their own.
//!
//! Only counted attempts are simulated. What one run simulated is not simulated again for the next.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::agents::imagined_candidates::{imagined_candidates, remembered};
use pathlight::agents::memory::{self, Memory, PuzzleSource, Settings as MemorySettings};
use pathlight::agents::online::{Candidate, OnlineAgent};
use pathlight::agents::{self, Agent, Observation, from_map, from_map_remembering, random};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::nets::{Card, PathNet, ReadScene};
use pathlight::puzzle::recorded_paths::RecordedPaths;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::stable_shuffle::stable_shuffle;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::{self, simulate};
use serde::{Deserialize, Serialize};

use super::task_set::TaskSet;
use crate::files::json_file;
use crate::files::weights_file::load_nets;
use crate::progress::Progress;

mod report;

pub use report::page;

/// What to measure.
#[derive(Default)]
pub struct Settings {
    pub fold: FoldId,
    pub tasks: TaskSet,
    /// Use only the first N of these tasks of each template.
    pub limit: Option<u16>,
    /// Seed of the random agent.
    pub seed: u64,
    /// Seeds of shuffled orders, to measure beside the order of ids.
    pub shuffles: Vec<u64>,
    /// Weights of the model; `None` are the shipped ones.
    pub weights: Option<PathBuf>,
}

/// What was measured, and how. The `--json` file.
#[derive(Serialize, Deserialize)]
pub struct Report {
    pub setup: Setup,
    pub fold: u8,
    pub tasks_of: TaskSet,
    pub seed: u64,
    pub simulator: u32,
    pub agents_version: u32,
    pub memory_version: u32,
    /// How the model was trained.
    pub card: Card,
    pub runs: Vec<Run>,
}

/// An agent at work on all tasks in one order.
#[derive(Serialize, Deserialize)]
pub struct Run {
    pub agent: AgentName,
    pub memory: MemoryUse,
    /// The seed of the order; absent if that is of ids.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shuffle: Option<u64>,
    /// In the order in which they were played: the first attempt that solved each task, counted from 1; null if none
    /// did.
    pub first_solved: Vec<(TaskId, Option<usize>)>,
}

/// What an agent remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MemoryUse {
    /// Nothing: it starts every task afresh.
    None,
    All,
    /// As if all scenes were alike.
    ScenesAlike,
    NoFailures,
    /// Places of balls in the scene alone, not relative to its bodies.
    NoRelativePlaces,
}

/// The file of a net that has learned from random scenes alone, on all tasks.
const ALONE: &str = "random-scenes-alone";

/// Reads the results of the folds of both setups from a folder, and those of a net that has learned from random scenes
/// alone.
///
/// # Errors
/// If one cannot be read, is of another fold than its name says or not of all its tasks, or there is none.
pub fn read(folder: &Path) -> anyhow::Result<Vec<Report>> {
    let folds = FoldId::all().map(|fold| (fold.to_string(), Some(fold)));
    let mut reports = Vec::new();
    for (name, fold) in folds.chain([(ALONE.to_string(), None)]) {
        let path = folder.join(name + ".json");
        if !path.exists() {
            continue;
        }
        let report: Report = json_file::read(&path, "pathlight-lab measure evaluate --carry")?;
        let found = FoldId { setup: report.setup, fold: report.fold };
        let name = path.display();
        ensure!(fold.is_none_or(|fold| fold == found), "{name} holds the results of {found}: name it {found}.json");
        ensure!(
            report.is_of(&report.tasks_of.tasks(found, None)),
            "{name} holds only some of the tasks: write it again with `pathlight-lab measure evaluate --carry --json`, \
             without --limit"
        );
        reports.push(report);
    }
    ensure!(
        !reports.is_empty(),
        "there are no results in {}: write some with `pathlight-lab measure evaluate --carry --json`",
        folder.display()
    );
    Ok(reports)
}

impl Report {
    /// Whether every run played exactly these tasks, in any order.
    fn is_of(&self, tasks: &[TaskId]) -> bool {
        self.runs.iter().all(|run| {
            let mut played: Vec<TaskId> = run.first_solved.iter().map(|&(task, _)| task).collect();
            played.sort();
            played == tasks
        })
    }
}

impl MemoryUse {
    pub const ALL: [MemoryUse; 5] =
        [MemoryUse::None, MemoryUse::All, MemoryUse::ScenesAlike, MemoryUse::NoFailures, MemoryUse::NoRelativePlaces];

    /// Returns the settings of the memory, if there is one.
    fn settings(self) -> Option<MemorySettings> {
        let all = MemorySettings::DEFAULT;
        match self {
            MemoryUse::None => None,
            MemoryUse::All => Some(all),
            MemoryUse::ScenesAlike => Some(MemorySettings { scene_length: f64::INFINITY, ..all }),
            MemoryUse::NoFailures => Some(MemorySettings { failure: 0.0, ..all }),
            MemoryUse::NoRelativePlaces => Some(MemorySettings { shares: [1.0, 0.0, 0.0], ..all }),
        }
    }
}

/// A task that is ready to be played again and again.
struct ReadyTask {
    id: TaskId,
    scene: Scene,
    read: ReadScene,
    candidates: Vec<Candidate>,
    /// The outcomes of the balls that were tried so far, by their coordinates.
    outcomes: HashMap<[u64; 3], Observation>,
}

impl Settings {
    /// Measures the agents.
    ///
    /// # Errors
    /// If the weights cannot be used for it.
    pub fn measure(&self, progress: &mut dyn Progress) -> anyhow::Result<Report> {
        let tasks = self.tasks.tasks(self.fold, self.limit);
        let (nets, card) = load_nets(self.weights.as_deref(), self.fold)?;
        AgentName::Online.check(&nets)?;
        self.tasks.check_dynamics(&card)?;
        progress.begin(tasks.len() as u64);
        let mut ready = Vec::with_capacity(tasks.len());
        for id in tasks {
            let scene = Task::load(id)?.scene;
            let candidates = imagined_candidates(&nets, &scene, MAX_ATTEMPTS).context("the weights are damaged")?;
            let read = nets.read(&scene).context("the weights have no dynamics net")?;
            ready.push(ReadyTask { id, scene, read, candidates, outcomes: HashMap::new() });
            progress.advance(1, "tasks read".to_string());
        }
        progress.finish(&format!("{} tasks read", ready.len()));
        let orders: Vec<Option<u64>> = std::iter::once(None).chain(self.shuffles.iter().copied().map(Some)).collect();
        // Without a memory the order makes no difference; ablations are measured in order of ids alone.
        let orders_of = |memory| if memory == MemoryUse::All { &orders[..] } else { &orders[..1] };
        // The dynamics net may be new to tasks from which the paper's nets have learned.
        let paper_is_new = match self.tasks {
            TaskSet::Test => true,
            TaskSet::Dev => card.without_dev,
            TaskSet::All => false,
        };
        let players = PLAYERS.iter().filter(|&&(agent, _)| agent != AgentName::Paper || paper_is_new);
        let all = players.flat_map(|&(agent, uses)| uses.iter().map(move |&memory| (agent, memory)));
        progress.begin(all.clone().map(|(_, memory)| orders_of(memory).len() as u64).sum());
        let mut runs = Vec::new();
        for (agent, memory) in all {
            for &shuffle in orders_of(memory) {
                let first_solved = self.run(agent, memory, shuffle, &nets, &mut ready);
                runs.push(Run { agent, memory, shuffle, first_solved });
                progress.advance(1, format!("runs, now of {agent}"));
            }
        }
        progress.finish(&format!("{} runs", runs.len()));
        let Settings { fold: FoldId { setup, fold }, seed, .. } = *self;
        Ok(Report {
            setup,
            fold,
            tasks_of: self.tasks,
            seed,
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            memory_version: memory::VERSION,
            card,
            runs,
        })
    }

    /// Lets an agent play all tasks in an order.
    fn run(
        &self,
        agent: AgentName,
        memory: MemoryUse,
        shuffle: Option<u64>,
        nets: &PathNet,
        tasks: &mut [ReadyTask],
    ) -> Vec<(TaskId, Option<usize>)> {
        let in_order = (0..tasks.len()).collect();
        let order =
            shuffle.map_or_else(|| in_order, |seed| stable_shuffle((0..tasks.len()).collect(), &seed.to_string()));
        let mut memory = memory.settings().map(Memory::new);
        let play = |index: usize| {
            let task = &mut tasks[index];
            let agent = task.start(agent, nets, memory.as_mut(), task.id.seed(self.seed));
            (task.id, task.play(agent, memory.as_mut()))
        };
        order.into_iter().map(play).collect()
    }
}

/// The agents that are measured, and what they remember.
const PLAYERS: [(AgentName, &[MemoryUse]); 4] = [
    (AgentName::OnlineByBalls, &MemoryUse::ALL),
    (AgentName::Online, &[MemoryUse::All]),
    (AgentName::Paper, &[MemoryUse::None, MemoryUse::All]),
    (AgentName::Random, &[MemoryUse::None, MemoryUse::All]),
];

impl ReadyTask {
    fn start(&self, agent: AgentName, nets: &PathNet, memory: Option<&mut Memory>, seed: u64) -> Box<dyn Agent> {
        let recollection = memory.map(|memory| memory.begin(PuzzleSource::Task(self.id), &self.scene));
        let Some(recollection) = recollection else {
            return match agent {
                AgentName::Paper => Box::new(from_map(nets, &self.scene, seed, MAX_ATTEMPTS).into_iter()),
                AgentName::Random => Box::new(random(&self.scene, seed, MAX_ATTEMPTS).into_iter()),
                _ => Box::new(OnlineAgent::new(self.candidates.clone(), agent.similarity())),
            };
        };
        let candidates = match agent {
            AgentName::Paper => from_map_remembering(nets, &self.scene, seed, MAX_ATTEMPTS, &recollection),
            AgentName::Random => recollection.random_candidates(&self.scene, seed, MAX_ATTEMPTS),
            _ => remembered(self.candidates.clone(), &self.read, &self.scene, &recollection),
        };
        Box::new(OnlineAgent::new(candidates, agent.similarity()))
    }

    /// Returns the first attempt that solves the task, counted from 1.
    fn play(&mut self, mut agent: Box<dyn Agent>, mut memory: Option<&mut Memory>) -> Option<usize> {
        (1..=MAX_ATTEMPTS).find(|_| {
            let Some(proposal) = agent.propose() else { return false };
            let place: [f64; 3] = proposal.ball.into();
            let outcome = self.outcomes.entry(place.map(f64::to_bits)).or_insert_with(|| {
                let rollout = simulate(&self.scene, Some(proposal.ball)).expect("agents propose valid balls");
                let paths = RecordedPaths::of(&rollout, &self.scene).and_then(|paths| paths.sampled());
                Observation { solved: rollout.solved, paths }
            });
            if let Some(memory) = memory.as_mut() {
                memory.observe(proposal.ball, proposal.chance().unwrap_or_default(), outcome.solved);
            }
            agent.observe(outcome);
            outcome.solved
        })
    }
}
