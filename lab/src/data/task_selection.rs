//! A selection of tasks: all, those of one template, or the first few of each template.

use pathlight::puzzle::task::{Task, TaskId, ids};
use pathlight::puzzle::templates::{TEMPLATES, Template};

/// Tasks of the benchmark.
#[derive(Clone, Copy)]
pub struct TaskSelection {
    /// Only the tasks of this template.
    pub template: Option<&'static Template>,
    /// Only the first N of each template.
    pub limit: usize,
}

impl Default for TaskSelection {
    fn default() -> TaskSelection {
        TaskSelection { template: None, limit: 100 }
    }
}

impl TaskSelection {
    /// The number of the selected template, if there is one.
    pub fn template(&self) -> Option<usize> {
        self.template.map(|template| template.number)
    }

    /// The ids of the tasks in ascending order.
    pub fn ids(&self) -> impl Iterator<Item = TaskId> + use<> {
        let (template, limit) = (self.template(), self.limit);
        let templates = TEMPLATES.iter().filter(move |one| template.is_none_or(|number| number == one.number));
        templates.flat_map(move |template| ids(template).take(limit))
    }

    /// The tasks in ascending order.
    pub fn tasks(&self) -> Vec<Task> {
        self.ids().map(|id| Task::load(id).expect("a task of the benchmark")).collect()
    }
}
