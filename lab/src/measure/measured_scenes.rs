//! The scenes that forecasts and chances are measured on: test tasks, or scenes that no net has seen.

use pathlight::benchmark::folds::FoldId;

use super::test_tasks;
use crate::data::scene_id::{HELD_OUT, SceneId};

/// Variants of a task that are tried before it is left out: some numbers have none that fits.
const VARIANTS: u32 = 20;

/// Which scenes to measure on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeasuredScenes {
    /// The test tasks of the fold.
    #[default]
    TestTasks,
    /// A variant of each test task.
    Variants,
    /// This many random scenes.
    Random(u32),
}

impl MeasuredScenes {
    /// Returns the scenes, of tasks at most those of the first `limit` of each template.
    pub fn ids(self, fold: FoldId, limit: Option<u16>) -> Vec<SceneId> {
        let tasks = if std::env::var("MEASURE_DEV").is_ok() { fold.tasks().dev } else { test_tasks(fold, limit) };
        match self {
            MeasuredScenes::TestTasks => tasks.into_iter().map(SceneId::Task).collect(),
            MeasuredScenes::Variants => {
                let variants = |task| (HELD_OUT..HELD_OUT + VARIANTS).map(move |number| SceneId::Variant(task, number));
                tasks.into_iter().filter_map(|task| variants(task).find(|variant| variant.scene().is_ok())).collect()
            }
            MeasuredScenes::Random(count) => (HELD_OUT..HELD_OUT + count).map(SceneId::Random).collect(),
        }
    }

    /// What they are, after their number.
    pub fn words(self) -> &'static str {
        match self {
            MeasuredScenes::TestTasks => "test tasks",
            MeasuredScenes::Variants => "variants of test tasks",
            MeasuredScenes::Random(_) => "random scenes",
        }
    }
}
