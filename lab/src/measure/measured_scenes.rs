//! The scenes that forecasts and chances are measured on: tasks of the benchmark, or scenes that no net has seen.

use pathlight::benchmark::folds::FoldId;
use pathlight::nets::Card;

use super::task_set::TaskSet;
use crate::data::scene_id::{HELD_OUT, SceneId};

/// Variants of a task that are tried before it is left out: some numbers have none that fits.
const VARIANTS: u32 = 20;

/// Which scenes to measure on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredScenes {
    /// Tasks of the benchmark.
    Tasks(TaskSet),
    /// A variant of each test task.
    Variants,
    /// This many random scenes.
    Random(u32),
}

impl Default for MeasuredScenes {
    fn default() -> MeasuredScenes {
        MeasuredScenes::Tasks(TaskSet::default())
    }
}

impl MeasuredScenes {
    /// Returns the scenes, of tasks at most those of the first `limit` of each template.
    pub fn ids(self, fold: FoldId, limit: Option<u16>) -> Vec<SceneId> {
        let tasks = self.task_set().tasks(fold, limit);
        match self {
            MeasuredScenes::Tasks(_) => tasks.into_iter().map(SceneId::Task).collect(),
            MeasuredScenes::Variants => {
                let variants = |task| (HELD_OUT..HELD_OUT + VARIANTS).map(move |number| SceneId::Variant(task, number));
                tasks.into_iter().filter_map(|task| variants(task).find(|variant| variant.scene().is_ok())).collect()
            }
            MeasuredScenes::Random(count) => (HELD_OUT..HELD_OUT + count).map(SceneId::Random).collect(),
        }
    }

    /// Checks that the dynamics net of a model has not seen them.
    ///
    /// # Errors
    /// If it may have.
    pub fn check(self, card: &Card) -> anyhow::Result<()> {
        self.task_set().check_dynamics(card)
    }

    /// The tasks that they are, or are variants of.
    fn task_set(self) -> TaskSet {
        match self {
            MeasuredScenes::Tasks(tasks) => tasks,
            MeasuredScenes::Variants | MeasuredScenes::Random(_) => TaskSet::Test,
        }
    }

    /// What they are, after their number.
    pub fn words(self) -> &'static str {
        match self {
            MeasuredScenes::Tasks(tasks) => tasks.words(),
            MeasuredScenes::Variants => "variants of test tasks",
            MeasuredScenes::Random(_) => "random scenes",
        }
    }
}
