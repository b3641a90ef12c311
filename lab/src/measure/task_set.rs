//! The sets of tasks that agents attempt.

use anyhow::ensure;
use pathlight::agents::agent_name::{AgentName, Needs};
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::Card;
use pathlight::puzzle::task::TaskId;
use serde::{Deserialize, Serialize};

/// A set of tasks of a fold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum TaskSet {
    /// The fold's test tasks.
    #[default]
    Test,
    /// The fold's dev tasks, to choose settings on.
    Dev,
}

impl TaskSet {
    /// The heading of a report on `count` of these tasks.
    pub fn heading(self, fold: FoldId, count: usize) -> String {
        format!("{}, fold {}, {count} {}", fold.setup, fold.fold, self.words())
    }

    /// Noun for the tasks, to follow their number.
    pub fn words(self) -> &'static str {
        match self {
            TaskSet::Test => "test tasks",
            TaskSet::Dev => "dev tasks",
        }
    }

    /// Returns the tasks in ascending order, at most the first `limit` per template.
    pub fn tasks(self, fold: FoldId, limit: Option<u16>) -> Vec<TaskId> {
        let tasks = match self {
            TaskSet::Test => fold.tasks().test,
            TaskSet::Dev => fold.tasks().dev,
        };
        let limit = limit.map_or(usize::MAX, usize::from);
        let templates = tasks.chunk_by(|a, b| a.template == b.template);
        templates.flat_map(|tasks| tasks.iter().copied().take(limit)).collect()
    }

    /// Checks that nets have not seen the tasks, if these are dev tasks. `train_command` trains such nets.
    ///
    /// # Errors
    /// If the nets were trained on the dev tasks too.
    pub fn check(self, without_dev: bool, train_command: &str) -> anyhow::Result<()> {
        ensure!(
            self != TaskSet::Dev || without_dev,
            "these nets were trained on the dev tasks too: train nets to measure with --dev by `pathlight-lab train \
             {train_command} --without-dev`"
        );
        Ok(())
    }

    /// The same for the nets of a model that an agent needs.
    ///
    /// # Errors
    /// If they were trained on the dev tasks too.
    pub fn check_model(self, agent: AgentName, card: &Card) -> anyhow::Result<()> {
        match (agent.needs(), &card.dynamics) {
            (Needs::Dynamics, Some(dynamics)) => self.check(!dynamics.has_seen_dev(), "dynamics"),
            _ => self.check(card.without_dev, "paths"),
        }
    }
}
