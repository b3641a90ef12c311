//! Training data: solutions, labelled balls, unlisted tasks and random scenes; and how hard the tasks are for uniform
//! balls.

pub mod collect;
pub mod difficulty;
pub mod label;
pub mod label_use;
pub mod labels;
pub mod random_scenes;
pub mod scene_id;
pub mod solutions;
pub mod task_selection;
pub mod unlisted_tasks;
