//! Which scene balls are tried in.

use std::fmt;

use anyhow::Context;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId, spread};
use pathlight::puzzle::templates::TEMPLATES;
use serde::{Deserialize, Serialize};

use super::random_scenes::random_scene;
use super::scene_blends::scene_blend;
use super::scene_variants::scene_variant;

/// Variants and random scenes of this number or a greater one are kept for measuring: `data label` tries no balls in
/// them.
pub const HELD_OUT: u32 = 1 << 31;

/// A scene that balls are tried in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SceneId {
    /// The scene of a task.
    Task(TaskId),
    /// A variant of the scene of a task.
    Variant(TaskId, u32),
    /// A scene between those of two tasks of a template.
    Blend(TaskId, TaskId, u32),
    /// A task that the benchmark does not list: template and combination of parameters.
    Unlisted(usize, u32),
    /// A random scene.
    Random(u32),
}

impl SceneId {
    /// The task that the scene belongs to or is made from. For a blend, the first of its two tasks.
    pub fn task(self) -> Option<TaskId> {
        match self {
            SceneId::Task(task) | SceneId::Variant(task, _) | SceneId::Blend(task, ..) => Some(task),
            SceneId::Unlisted(..) | SceneId::Random(_) => None,
        }
    }

    /// The scene of the task that it is made from, for a blend of the first; itself if it is made from none.
    pub fn unchanged(self) -> SceneId {
        self.task().map_or(self, SceneId::Task)
    }

    /// Makes the scene.
    ///
    /// # Errors
    /// If there is no such scene.
    pub fn scene(self) -> anyhow::Result<Scene> {
        match self {
            SceneId::Task(task) => Ok(Task::load(task)?.scene),
            SceneId::Variant(task, number) => scene_variant(&Task::load(task)?, number)
                .with_context(|| format!("variant {number} of {task} is not made any more: label the variants again")),
            SceneId::Blend(first, second, number) => scene_blend(&Task::load(first)?, &Task::load(second)?, number)
                .with_context(|| {
                    format!("blend {number} of {first} and {second} is not made any more: label the blends again")
                }),
            SceneId::Unlisted(template, combination) => {
                let of_template = TEMPLATES.get(template);
                of_template.and_then(|template| template.unlisted(combination)).with_context(|| {
                    format!("template {template:05} has no unlisted task {combination}: label the unlisted tasks again")
                })
            }
            SceneId::Random(number) => Ok(random_scene(number)),
        }
    }

    /// Returns the seed of the random draws for this scene, given the seed of the command. A variant has that of its
    /// task, and a blend that of its first task. The lowest 16 bits are left for the number of the round.
    pub fn seed(self, global_seed: u64) -> u64 {
        match self {
            SceneId::Task(task) | SceneId::Variant(task, _) | SceneId::Blend(task, ..) => task.seed(global_seed),
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
            SceneId::Variant(task, number) => write!(f, "variant {number} of {task}"),
            SceneId::Blend(first, second, number) => write!(f, "blend {number} of {first} and {second}"),
            SceneId::Unlisted(template, combination) => write!(f, "unlisted task {combination} of {template:05}"),
            SceneId::Random(number) => write!(f, "random scene {number}"),
        }
    }
}
