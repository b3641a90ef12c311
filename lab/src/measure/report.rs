//! The report of `measure evaluate`: the first solving attempt of each agent at each task, as JSON and as a table. The
//! results of `reproduce` are such reports.

use std::fmt::{self, Write as _};
use std::path::Path;

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::nets::{Card, DqnCard};
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::Engine;
use serde::{Deserialize, Serialize};

use super::task_set::TaskSet;
use crate::files::json_file;

/// The measurement and its settings: the content of the `--json` file.
#[derive(Serialize, Deserialize)]
pub struct Report {
    pub setup: Setup,
    pub fold: u8,
    pub tasks_of: TaskSet,
    /// Maximum number of tasks per template; absent if all were measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit: Option<u16>,
    pub seed: u64,
    /// The engine that simulated the attempts; absent if it is the first engine.
    #[serde(default, skip_serializing_if = "Engine::is_first")]
    pub engine: Engine,
    /// The version of the engine.
    pub simulator: u32,
    /// `agents::VERSION`
    pub agents_version: u32,
    /// How the model was trained, if it was measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub card: Option<Card>,
    /// How DQN was trained, if it was measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dqn: Option<DqnCard>,
    pub agents: Vec<Score>,
    /// The commands of the recipe, if `reproduce` made the report.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub made_by: Vec<String>,
    /// Wall-clock time of these commands times the number of threads. Those already run for another result take none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub core_minutes: Option<f64>,
}

/// An agent, with or without a memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Player {
    pub agent: AgentName,
    /// Order in which the agent played the tasks, if it has a memory.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub memory: Option<Order>,
}

/// Order in which an agent with a memory plays the tasks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Order {
    Ids,
    /// Shuffled with this seed.
    Shuffled(u64),
}

/// The results of a player.
#[derive(Serialize, Deserialize)]
pub struct Score {
    #[serde(flatten)]
    pub player: Player,
    /// 0..=100
    pub auccess: f64,
    /// For each task in order of ids, the first attempt that solved it, counted from 1; null if none did.
    pub first_solved: Vec<Option<usize>>,
}

impl From<AgentName> for Player {
    /// The agent without a memory.
    fn from(agent: AgentName) -> Player {
        Player { agent, memory: None }
    }
}

impl fmt::Display for Player {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.memory {
            None => self.agent.fmt(f),
            Some(Order::Ids) => write!(f, "{}, memory", self.agent),
            Some(Order::Shuffled(seed)) => write!(f, "{}, memory, order {seed}", self.agent),
        }
    }
}

impl Score {
    pub fn new(player: impl Into<Player>, first_solved: Vec<Option<usize>>) -> Score {
        Score { player: player.into(), auccess: auccess(&first_solved), first_solved }
    }
}

/// Formats auccess, and the percentages solved at the first attempt, within 10 and within 100, as a Markdown cell.
pub fn score_cell(firsts: &[Option<usize>]) -> String {
    let [auccess, first, ten, hundred] = score_of(firsts);
    format!("**{auccess:.1}** {first:.0} / {ten:.0} / {hundred:.0} %")
}

/// Auccess, and the percentages of tasks solved at the first attempt, within 10 and within 100.
fn score_of(firsts: &[Option<usize>]) -> [f64; 4] {
    let [first, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved_within(firsts, attempts));
    [auccess(firsts), first, ten, hundred]
}

impl Report {
    /// Reads a file of `measure evaluate --json`. `command` is the command that makes it.
    ///
    /// # Errors
    /// If the file is missing or damaged, or a list does not have one entry per task.
    pub fn read(path: &Path, command: &str) -> anyhow::Result<Report> {
        let report: Report = json_file::read(path, command)?;
        let tasks = report.tasks().len();
        anyhow::ensure!(
            report.agents.iter().all(|score| score.first_solved.len() == tasks),
            "{} does not hold an attempt for each of its {tasks} tasks: write it again with `{command}`",
            path.display()
        );
        Ok(report)
    }

    pub fn fold_id(&self) -> FoldId {
        FoldId { setup: self.setup, fold: self.fold }
    }

    /// The tasks that were attempted, ascending.
    pub fn tasks(&self) -> Vec<TaskId> {
        self.tasks_of.tasks(self.fold_id(), self.limit)
    }

    /// Whether the report covers all test tasks of its fold.
    pub fn is_complete(&self) -> bool {
        self.tasks_of == TaskSet::Test && self.limit.is_none()
    }

    /// The first solving attempts of a player; `None` if the player was not measured.
    pub fn first_solved(&self, player: impl Into<Player>) -> Option<&[Option<usize>]> {
        let player = player.into();
        self.agents.iter().find(|score| score.player == player).map(|score| &score.first_solved[..])
    }

    /// The first solving attempts of a player at the tasks of a template; empty if the player was not measured.
    pub fn of_template(&self, player: impl Into<Player>, template: usize) -> Vec<Option<usize>> {
        let firsts = self.first_solved(player).unwrap_or_default();
        let of_tasks = self.tasks().into_iter().zip(firsts);
        of_tasks.filter(|(task, _)| task.template == template).map(|(_, &first)| first).collect()
    }

    /// Formats the results as a table: one row per template and one for all.
    ///
    /// # Errors
    /// Only if formatting fails.
    pub fn table(&self) -> Result<String, fmt::Error> {
        let tasks = self.tasks();
        let &Report { tasks_of, seed, engine, simulator, .. } = self;
        let mut text = String::new();
        write!(text, "{}, seed {seed}, ", tasks_of.heading(self.fold_id(), tasks.len()))?;
        if !engine.is_first() {
            write!(text, "engine {engine}, ")?;
        }
        writeln!(text, "simulator {simulator}")?;
        for training in self.trainings() {
            writeln!(text, "{training}")?;
        }
        write!(text, "{:30} {:>5}", "template", "tasks")?;
        for Score { player, .. } in &self.agents {
            write!(text, "  {:>15} {:>6} {:>6} {:>6}", format!("{player}: auccess"), "1st", "<= 10", "<= 100")?;
        }
        writeln!(text)?;
        let row = |text: &mut String, name: &str, from: usize, to: usize| {
            write!(text, "{name:30} {:>5}", to - from)?;
            for score in &self.agents {
                let [auccess, first, ten, hundred] = score_of(&score.first_solved[from..to]);
                write!(text, "  {auccess:>15.1} {first:>4.0} % {ten:>4.0} % {hundred:>4.0} %")?;
            }
            writeln!(text)
        };
        let mut from = 0;
        for of_template in tasks.chunk_by(|a, b| a.template == b.template) {
            let template = TEMPLATES[of_template[0].template];
            let to = from + of_template.len();
            row(&mut text, &format!("{:05} {}", template.number, template.name), from, to)?;
            from = to;
        }
        row(&mut text, "all", 0, tasks.len())?;
        Ok(text)
    }

    /// Describes how the measured nets were trained, in one sentence each.
    pub fn trainings(&self) -> Vec<String> {
        let mut sentences = Vec::new();
        if let Some(card) = &self.card {
            let Card { samples, tasks, epochs, .. } = card;
            if self.first_solved(AgentName::Paper).is_some() {
                sentences.push(format!("the four nets: {samples} solutions of {tasks} tasks, {epochs} epochs"));
            }
            if let Some(success) = &card.success {
                sentences.push(format!("success net: {} balls, {} epochs", success.balls, success.epochs));
            }
            if let Some(net) = &card.dynamics {
                let scenes = [(net.unlisted, "unlisted tasks"), (net.random_scenes, "random scenes")];
                let scenes = scenes.iter().filter(|(count, _)| *count > 0).map(|(count, of)| format!(", {count} {of}"));
                let scenes: String = scenes.collect();
                let last = format!("{} balls, {} epochs", net.balls, net.epochs);
                sentences.push(match &net.from {
                    None => format!("dynamics net: {last}{scenes}"),
                    // The nets before may have learned from these scenes, and the last training not.
                    Some(_) => format!("dynamics net{scenes}, in its last training: {last}"),
                });
            }
        }
        sentences.extend(self.dqn.as_ref().map(|card| format!("DQN: {} balls, {} epochs", card.balls, card.epochs)));
        sentences
    }
}
