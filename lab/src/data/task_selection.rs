//! The tasks of a search: all, those of one template, or the first few of each.

use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::{TEMPLATES, Template};

/// Tasks of the benchmark.
#[derive(Clone, Copy)]
pub struct TaskSelection {
    /// Only the tasks of this template.
    pub template: Option<&'static Template>,
    /// At most the first of each template.
    pub limit: usize,
}

impl Default for TaskSelection {
    fn default() -> TaskSelection {
        TaskSelection { template: None, limit: 100 }
    }
}

impl TaskSelection {
    /// The number of the one template, if there is only one.
    pub fn template(&self) -> Option<usize> {
        self.template.map(|template| template.number)
    }

    /// The tasks in ascending order.
    pub fn tasks(&self) -> Vec<Task> {
        let templates =
            TEMPLATES.iter().filter(|template| self.template().is_none_or(|number| number == template.number));
        templates.flat_map(|template| Task::of(template).take(self.limit)).collect()
    }
}
