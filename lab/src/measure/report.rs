//! What `measure evaluate` finds: the results of each agent on each task, as JSON and as a table.

use std::fmt::{self, Write as _};

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::nets::{Card, DqnCard, DynamicsCard};
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::Engine;
use serde::{Deserialize, Serialize};

use super::task_set::TaskSet;

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

impl Score {
    /// Returns the results of these first solving attempts.
    pub fn new(agent: AgentName, first_solved: Vec<(TaskId, Option<usize>)>) -> Score {
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

    pub fn fold_id(&self) -> FoldId {
        FoldId { setup: self.setup, fold: self.fold }
    }

    /// Whether every agent was measured on exactly these tasks.
    pub fn is_of(&self, tasks: &[TaskId]) -> bool {
        self.agents.iter().all(|score| score.first_solved.iter().map(|(task, _)| task).eq(tasks))
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
        (!firsts.is_empty()).then(|| score_of(&firsts))
    }

    /// The results as a table for people: a row per template and one for all.
    pub fn table(&self) -> Result<String, fmt::Error> {
        // All agents attempt the same tasks.
        let attempted = self.agents.first().map_or(&[][..], |score| &score.first_solved);
        let tasks: Vec<TaskId> = attempted.iter().map(|&(task, _)| task).collect();
        let &Report { tasks_of, seed, engine, simulator, .. } = self;
        let mut text = String::new();
        write!(text, "{}, seed {seed}, ", tasks_of.heading(self.fold_id(), tasks.len()))?;
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
                for count in scene_counts(dynamics) {
                    write!(text, ", {count}")?;
                }
                if dynamics.from.is_some() {
                    write!(text, ", trained further from other weights")?;
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
            let [auccess, first, ten, hundred] = score_of(&firsts);
            write!(text, "  {auccess:>15.1} {first:>4.0} % {ten:>4.0} % {hundred:>4.0} %")?;
        }
        writeln!(text)
    }
}

/// Auccess, and the percentages of tasks solved at the first attempt, within 10 and within 100, of the first solving
/// attempts at some tasks.
pub fn score_of(firsts: &[Option<usize>]) -> [f64; 4] {
    let [first, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved_within(firsts, attempts));
    [auccess(firsts), first, ten, hundred]
}

/// How many scenes of each kind a dynamics net has learned from, beside those of the tasks: "12 variants".
pub fn scene_counts(card: &DynamicsCard) -> impl Iterator<Item = String> {
    let counts = [
        (card.variants, "variants"),
        (card.blends, "blends"),
        (card.unlisted, "unlisted tasks"),
        (card.random_scenes, "random scenes"),
    ];
    counts.into_iter().filter(|(count, _)| *count > 0).map(|(count, of)| format!("{count} {of}"))
}
