//! Which tasks of the benchmark agents attempt.

use anyhow::ensure;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::Card;
use pathlight::puzzle::task::TaskId;
use serde::{Deserialize, Serialize};

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
        let words = self.words();
        match self {
            TaskSet::Test | TaskSet::Dev => format!("{setup}, fold {fold}, {count} {words}"),
            TaskSet::All => format!("all templates, {count} {words}"),
        }
    }

    /// What they are, after their number.
    pub fn words(self) -> &'static str {
        match self {
            TaskSet::Test => "test tasks",
            TaskSet::Dev => "dev tasks",
            TaskSet::All => "tasks",
        }
    }

    /// Returns the tasks in ascending order, at most the first `limit` of each template.
    pub fn tasks(self, fold: FoldId, limit: Option<u16>) -> Vec<TaskId> {
        let tasks = match self {
            TaskSet::Test => fold.tasks().test,
            TaskSet::Dev => fold.tasks().dev,
            TaskSet::All => TaskSelection::default().ids().collect(),
        };
        let limit = limit.map_or(usize::MAX, usize::from);
        let templates = tasks.chunk_by(|a, b| a.template == b.template);
        templates.flat_map(|tasks| tasks.iter().copied().take(limit)).collect()
    }

    /// Checks that nets have not seen the tasks, if these are dev tasks. `train_command` trains such nets.
    ///
    /// # Errors
    /// If they were trained on the dev tasks too.
    pub fn check(self, without_dev: bool, train_command: &str) -> anyhow::Result<()> {
        ensure!(
            self != TaskSet::Dev || without_dev,
            "these nets were trained on the dev tasks too, so --dev would measure nothing new: train some with \
             `pathlight-lab train {train_command} --without-dev`"
        );
        Ok(())
    }

    /// Checks that the dynamics net of a model, if it has one, has seen none of the tasks.
    ///
    /// # Errors
    /// If it may have.
    pub fn check_dynamics(self, card: &Card) -> anyhow::Result<()> {
        let dynamics = card.dynamics.as_ref();
        let without_dev = dynamics.is_none_or(|dynamics| dynamics.without_dev || dynamics.random_scenes_alone);
        self.check(without_dev, "dynamics")?;
        ensure!(
            self != TaskSet::All || dynamics.is_some_and(|dynamics| dynamics.random_scenes_alone),
            "these nets were trained on some of the tasks, so --all-tasks would not measure what is new to them: train \
             a dynamics net with `pathlight-lab train dynamics` on labels of random scenes alone"
        );
        Ok(())
    }
}
