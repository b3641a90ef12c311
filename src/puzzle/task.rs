//! Tasks: numbered scenes of a template, each with its id, its parameters and its goal in words.
//!
//! Parses ids and loads their tasks. Used by everything above the templates.

use std::{fmt, str::FromStr};

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::puzzle::scene::Scene;
use crate::puzzle::templates::{TEMPLATES, Template};

/// Template and number of a task, written `00007:008`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct TaskId {
    /// Index into `TEMPLATES`.
    pub template: usize,
    /// 0..=999. The benchmark contains only some numbers of each template.
    pub number: u16,
}

/// Why a task cannot be loaded.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
pub enum TaskError {
    #[error("`{0}` is not a task id: write template and number like 00007:008")]
    Malformed(String),
    #[error("unknown template `{0}`: templates run from 00000 to {last:05}", last = TEMPLATES.len() - 1)]
    NoTemplate(String),
    #[error("task {0} is not in the benchmark: `pathlight tasks --template {template:05}` lists the tasks of this template", template = .0.template)]
    NotInBenchmark(TaskId),
}

/// One of the benchmark's tasks. Its JSON is one line of `pathlight tasks --json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Task {
    /// Template and number.
    pub id: TaskId,
    /// The value of each parameter of the template.
    pub params: Map<String, Value>,
    /// The goal sentence.
    pub goal: String,
    /// The bodies and the goal.
    #[serde(flatten)]
    pub scene: Scene,
}

impl Task {
    /// Returns the task with this id.
    ///
    /// # Errors
    /// `NoTemplate` or `NotInBenchmark` if the benchmark has no such task.
    pub fn load(id: TaskId) -> Result<Task, TaskError> {
        let template =
            TEMPLATES.get(id.template).ok_or_else(|| TaskError::NoTemplate(format!("{:05}", id.template)))?;
        let (params, scene) = template.task(id.number).ok_or(TaskError::NotInBenchmark(id))?;
        let goal = goal_sentence(&scene);
        Ok(Task { id, params: params.into_json(), goal, scene })
    }

    /// Returns the tasks of a template, ascending.
    pub fn of(template: &'static Template) -> impl Iterator<Item = Task> {
        ids(template).map(|id| Task::load(id).expect("a template lists its own tasks"))
    }
}

/// Returns the ids of a template's tasks, ascending.
pub fn ids(template: &Template) -> impl Iterator<Item = TaskId> {
    let number = template.number;
    template.task_numbers.iter().map(move |&task| TaskId { template: number, number: task })
}

/// Returns the goal of a scene as a sentence.
pub fn goal_sentence(scene: &Scene) -> String {
    let [object, target] = [scene.body1, scene.body2].map(|body| scene.bodies[body].name());
    format!("Make sure the {object} is touching the {target}.")
}

impl TaskId {
    /// Returns the seed of the random draws for this task, given the seed of the whole command or page. The page,
    /// `propose` and `evaluate` draw the same numbers.
    pub fn seed(self, global_seed: u64) -> u64 {
        spread(global_seed) ^ ((self.template as u64) << 32 | u64::from(self.number) << 16)
    }
}

/// Spreads seeds over 64 bits by an odd factor (Knuth's multiplicative hashing).
pub fn spread(global_seed: u64) -> u64 {
    global_seed.wrapping_mul(0x9E37_79B9_7F4A_7C15)
}

impl fmt::Display for TaskId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:05}:{:03}", self.template, self.number)
    }
}

impl FromStr for TaskId {
    type Err = TaskError;

    fn from_str(text: &str) -> Result<TaskId, TaskError> {
        let malformed = || TaskError::Malformed(text.to_string());
        let digits = |part: &str, count: usize| part.len() == count && part.bytes().all(|b| b.is_ascii_digit());
        let (template, number) = text.split_once(':').ok_or_else(malformed)?;
        if !digits(template, 5) || !digits(number, 3) {
            return Err(malformed());
        }
        Ok(TaskId {
            template: template.parse().map_err(|_| malformed())?,
            number: number.parse().map_err(|_| malformed())?,
        })
    }
}

impl From<TaskId> for String {
    fn from(id: TaskId) -> String {
        id.to_string()
    }
}

impl TryFrom<String> for TaskId {
    type Error = TaskError;

    fn try_from(text: String) -> Result<TaskId, TaskError> {
        text.parse()
    }
}
