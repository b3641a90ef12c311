//! Pathlight.
pub mod action;
pub mod auccess;
pub mod folds;
pub mod layout;
pub mod pathnet;
pub mod placement;
pub mod raster;
pub mod rollout;
pub mod samples;
pub mod scene;
pub mod simulator;
pub mod solutions;
pub mod task;
pub mod templates;
