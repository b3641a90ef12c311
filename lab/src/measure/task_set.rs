//! Which tasks of the benchmark agents attempt.

use anyhow::ensure;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::Card;
use pathlight::puzzle::task::TaskId;
use serde::{Deserialize, Serialize};

use super::first_of_each_template;
use crate::data::task_selection::TaskSelection;

/// Tasks of the benchmark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum TaskSet {
    /// The fold's test tasks.
    #[default]
    Test,
    /// The fold's dev tasks, to choose settings on.
    Dev,
    /// All 2,500, for nets that have seen none of them.
    All,
}

impl TaskSet {
    /// The heading of a report on this many of its tasks.
    pub fn heading(self, fold: FoldId, count: usize) -> String {
        let FoldId { setup, fold } = fold;
        match self {
            TaskSet::Test => format!("{setup}, fold {fold}, {count} test tasks"),
            TaskSet::Dev => format!("{setup}, fold {fold}, {count} dev tasks"),
            TaskSet::All => format!("all templates, {count} tasks"),
        }
    }

    /// Returns the tasks in ascending order, at most the first `limit` of each template.
    pub fn tasks(self, fold: FoldId, limit: Option<u16>) -> Vec<TaskId> {
        let tasks = match self {
            TaskSet::Test => fold.tasks().test,
            TaskSet::Dev => fold.tasks().dev,
            TaskSet::All => TaskSelection::default().ids().collect(),
        };
        first_of_each_template(&tasks, limit)
    }

    /// Checks that the dynamics net of a model has seen none of the tasks.
    ///
    /// # Errors
    /// If it may have.
    pub fn check_dynamics(self, card: &Card) -> anyhow::Result<()> {
        let dynamics = card.dynamics.as_ref();
        match self {
            TaskSet::Test => {}
            TaskSet::Dev => ensure!(
                std::env::var("PATHLIGHT_SEEN").is_ok()
                    || dynamics.is_none_or(|dynamics| dynamics.without_dev || dynamics.random_scenes_alone),
                "the dynamics net was trained on the dev tasks too, so --dev would measure nothing new: train one with \
                 `pathlight-lab train dynamics --without-dev`"
            ),
            TaskSet::All => ensure!(
                dynamics.is_some_and(|dynamics| dynamics.random_scenes_alone),
                "these nets were trained on some of the tasks, so --all-tasks would not measure what is new to them: \
                 train a dynamics net with `pathlight-lab train dynamics` on labels of random scenes alone"
            ),
        }
        Ok(())
    }
}
