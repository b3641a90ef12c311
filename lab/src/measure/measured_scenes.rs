//! The scenes that forecasts are measured on: tasks of the benchmark, or scenes that no net has seen.

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::Card;

use super::task_set::TaskSet;
use crate::data::scene_id::{HELD_OUT, SceneId};

/// Which scenes to measure on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredScenes {
    /// Tasks of the benchmark.
    Tasks(TaskSet),
    /// This many random scenes.
    Random(u32),
}

impl MeasuredScenes {
    /// Returns the ids of the scenes; of tasks, at most the first `limit` per template.
    pub fn ids(self, fold: FoldId, limit: Option<u16>) -> Vec<SceneId> {
        match self {
            MeasuredScenes::Tasks(tasks) => tasks.tasks(fold, limit).into_iter().map(SceneId::Task).collect(),
            MeasuredScenes::Random(count) => (HELD_OUT..HELD_OUT + count).map(SceneId::Random).collect(),
        }
    }

    /// Checks that the dynamics net of a model has not seen the scenes.
    ///
    /// # Errors
    /// If it may have seen them.
    pub fn check(self, card: &Card) -> anyhow::Result<()> {
        if let MeasuredScenes::Tasks(tasks) = self { tasks.check_model(AgentName::Dynamics, card) } else { Ok(()) }
    }

    /// Noun for the scenes, to follow their number.
    pub fn words(self) -> &'static str {
        match self {
            MeasuredScenes::Tasks(tasks) => tasks.words(),
            MeasuredScenes::Random(_) => "random scenes",
        }
    }
}
