//! The ids of the scenes that balls are tried in.

use std::fmt;

use anyhow::Context;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId, spread};
use pathlight::puzzle::templates::TEMPLATES;
use serde::{Deserialize, Serialize};

use super::random_scenes::random_scene;

/// Random scenes from this number on are held out for measurements; `data label` does not use them.
pub const HELD_OUT: u32 = 1 << 31;

/// A scene that balls are tried in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SceneId {
    /// The scene of a task.
    Task(TaskId),
    /// A task that the benchmark does not list: template and combination of parameters.
    Unlisted(usize, u32),
    /// A random scene, by its number.
    Random(u32),
}

impl SceneId {
    /// The task that the scene belongs to, if any.
    pub fn task(self) -> Option<TaskId> {
        if let SceneId::Task(task) = self { Some(task) } else { None }
    }

    /// Makes the scene.
    ///
    /// # Errors
    /// If the scene does not exist.
    pub fn scene(self) -> anyhow::Result<Scene> {
        match self {
            SceneId::Task(task) => Ok(Task::load(task)?.scene),
            SceneId::Unlisted(template, combination) => {
                let of_template = TEMPLATES.get(template);
                of_template.and_then(|template| template.unlisted(combination)).with_context(|| {
                    format!("template {template:05} has no unlisted task {combination}: label the unlisted tasks again")
                })
            }
            SceneId::Random(number) => Ok(random_scene(number)),
        }
    }

    /// Returns the seed of the random draws for this scene, given the seed of the command. The lowest 16 bits are
    /// reserved for the number of the round.
    pub fn seed(self, global_seed: u64) -> u64 {
        match self {
            SceneId::Task(task) => task.seed(global_seed),
            SceneId::Unlisted(template, combination) => {
                spread(global_seed) ^ (template as u64 + 1) << 48 ^ u64::from(combination) << 16
            }
            SceneId::Random(number) => spread(global_seed) ^ u64::from(number) << 20,
        }
    }
}

impl fmt::Display for SceneId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneId::Task(task) => write!(f, "{task}"),
            SceneId::Unlisted(template, combination) => write!(f, "unlisted task {combination} of {template:05}"),
            SceneId::Random(number) => write!(f, "random scene {number}"),
        }
    }
}
