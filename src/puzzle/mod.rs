//! What is asked, tried and what came of it, as plain data: scenes, actions, rollouts, and the benchmark's 2,500 tasks.
//!
//! Everything else uses this folder; it uses nothing but itself.

pub mod action;
pub mod layout;
pub mod rollout;
pub mod scene;
pub mod task;
pub mod templates;
