//! The scenes of tasks, kept: for commands that come back to the same tasks again and again.
//!
//! A template numbers its tasks by laying out all of them up to the one asked for, so the first question about
//! a template lays out its 100 tasks at once. Can be asked from many threads.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskError, TaskId};
use pathlight::puzzle::templates::TEMPLATES;

/// For each template, the scenes of its tasks by number, once somebody has asked.
pub struct SceneCache(Vec<OnceLock<BTreeMap<u16, Scene>>>);

impl SceneCache {
    pub fn new() -> SceneCache {
        SceneCache(TEMPLATES.iter().map(|_| OnceLock::new()).collect())
    }

    /// The scene of a task.
    ///
    /// # Errors
    /// As `Task::load`.
    pub fn get(&self, id: TaskId) -> Result<&Scene, TaskError> {
        let (Some(template), Some(kept)) = (TEMPLATES.get(id.template), self.0.get(id.template)) else {
            return Err(TaskError::NoTemplate(format!("{:05}", id.template)));
        };
        let scenes = kept.get_or_init(|| Task::of(template).map(|task| (task.id.number, task.scene)).collect());
        scenes.get(&id.number).ok_or(TaskError::NotInBenchmark(id))
    }
}
