//! What nets learn from: the search for solutions, balls labelled with their outcome, variants and blends of
//! scenes, unlisted tasks, random scenes, and training images; and how hard the tasks are for uniform balls.

pub mod collect;
pub mod difficulty;
pub mod label;
pub mod label_use;
pub mod labels;
pub mod merge;
pub mod random_scenes;
pub mod samples;
pub mod scene_blends;
pub mod scene_id;
pub mod scene_variants;
pub mod solutions;
pub mod solve_rates;
pub mod task_selection;
pub mod unlisted_tasks;
