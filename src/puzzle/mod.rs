//! The benchmark's puzzles as plain data: scenes, actions and their validity, rollouts, templates and their tasks.
//!
//! Every other folder uses this one, and it uses none of them.

pub mod action;
pub mod custom_scene;
pub mod dimensions;
pub mod hex;
pub mod layout;
pub mod nearest_place;
pub(crate) mod numpy;
pub mod recorded_paths;
pub mod rollout;
pub mod sampled_paths;
pub mod sampling;
pub mod scene;
pub mod scene_form;
pub mod stable_shuffle;
pub mod task;
pub mod templates;
pub mod utf8;
