//! Tasks: one numbered scene of a template, with its id, its parameters and its goal in words.
//!
//! The way from an id that someone typed to a scene. Used by everything above the templates.

use std::{fmt, str::FromStr};

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::puzzle::scene::{Body, Scene};
use crate::puzzle::templates::{TEMPLATES, Template, grid::Params};

/// Template and number of a task: `00007:008`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct TaskId {
    /// 0..=24
    pub template: usize,
    /// 0..=998; which 100 there are differs from template to template.
    pub number: u16,
}

/// Why something is no task id.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TaskError {
    #[error("`{0}` is no task id: write template and number like 00007:008")]
    Malformed(String),
    #[error("there is no template `{0}`: they run from 00000 to 00024")]
    NoTemplate(String),
    #[error("the benchmark keeps no task {0}: `pathlight tasks --template {template:05}` lists those of the template", template = .0.template)]
    NotKept(TaskId),
}

/// One of the 2,500 tasks of the benchmark. Its JSON is one line of `pathlight tasks --json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Task {
    pub id: TaskId,
    /// The value of each parameter of the template.
    pub params: Map<String, Value>,
    /// The goal sentence.
    pub goal: String,
    #[serde(flatten)]
    pub scene: Scene,
}

impl Task {
    /// The task of this id.
    ///
    /// # Errors
    /// `NoTemplate` or `NotKept` if the benchmark has no such task.
    pub fn load(id: TaskId) -> Result<Task, TaskError> {
        let template =
            TEMPLATES.get(id.template).ok_or_else(|| TaskError::NoTemplate(format!("{:05}", id.template)))?;
        let (params, scene) = template.task(id.number).ok_or(TaskError::NotKept(id))?;
        Ok(Task::new(id, params, scene))
    }

    /// The 100 tasks of a template, ascending.
    pub fn of(template: &'static Template) -> impl Iterator<Item = Task> {
        template
            .tasks()
            .map(|(number, params, scene)| Task::new(TaskId { template: template.number, number }, params, scene))
    }

    fn new(id: TaskId, params: Params, scene: Scene) -> Task {
        let goal = goal_sentence(&scene.bodies[scene.body1], &scene.bodies[scene.body2]);
        Task { id, params: params.into_json(), goal, scene }
    }
}

/// The ids of a template's 100 tasks, ascending.
pub fn ids(template: &Template) -> impl Iterator<Item = TaskId> {
    let number = template.number;
    template.selected.iter().map(move |&task| TaskId { template: number, number: task })
}

fn goal_sentence(object: &Body, target: &Body) -> String {
    format!("Make sure the {} is touching the {}.", object.name(), target.name())
}

impl TaskId {
    /// The seed of what is drawn at random for this task in a run with a seed of its own: the page, `propose`
    /// and `evaluate` draw the same.
    pub fn seed(self, run: u64) -> u64 {
        // An odd constant spreads the runs over the 64 bits (Knuth's multiplicative hashing).
        run.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ ((self.template as u64) << 32 | u64::from(self.number) << 16)
    }
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
