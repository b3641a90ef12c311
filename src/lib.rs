//! Pathlight.
pub mod action;
pub mod layout;
pub mod rollout;
pub mod scene;
pub mod simulator;
pub mod task;
pub mod templates;
