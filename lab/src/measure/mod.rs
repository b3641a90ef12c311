//! Measurements: agents, forecasts and chances on the test tasks of a fold, forecasts and chances in scenes of other
//! kinds, and the simulator beside PHYRE's.

use pathlight::benchmark::folds::FoldId;
use pathlight::puzzle::task::TaskId;

pub mod agents;
pub mod calibration;
pub mod carried;
pub mod evaluate;
pub mod fidelity;
pub mod fold_reports;
pub mod forecasts;
pub mod measured_scenes;
pub mod paper_table;
pub mod publish_results;
pub mod shipped;
pub mod task_set;

/// Returns the test tasks of a fold, at most the first `limit` of each template.
fn test_tasks(fold: FoldId, limit: Option<u16>) -> Vec<TaskId> {
    first_of_each_template(&fold.tasks().test, limit)
}

/// Returns at most the first `limit` tasks of each template, of tasks in ascending order.
fn first_of_each_template(tasks: &[TaskId], limit: Option<u16>) -> Vec<TaskId> {
    let limit = limit.map_or(usize::MAX, usize::from);
    let templates = tasks.chunk_by(|a, b| a.template == b.template);
    templates.flat_map(|tasks| tasks.iter().copied().take(limit)).collect()
}
