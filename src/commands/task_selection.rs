//! The arguments that select the tasks of a command: all, those of one template, or the first few of each.

use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::{TEMPLATES, Template};

/// Tasks of the benchmark; part of the arguments of `collect` and `label`.
#[derive(clap::Args)]
pub struct TaskSelection {
    /// Use only the tasks of this template, like 00007
    #[arg(long, value_name = "TEMPLATE", value_parser = super::template)]
    template: Option<&'static Template>,

    /// Use at most the first N tasks of each template
    #[arg(long, value_name = "N", default_value_t = 100)]
    pub limit: usize,
}

impl TaskSelection {
    /// The number of the one template, if there is only one.
    pub fn template(&self) -> Option<usize> {
        self.template.map(|template| template.number)
    }

    /// The tasks in ascending order.
    pub fn tasks(&self) -> Vec<Task> {
        let templates = TEMPLATES.iter().filter(|all| self.template.is_none_or(|one| one.number == all.number));
        templates.flat_map(|template| Task::of(template).take(self.limit)).collect()
    }
}
