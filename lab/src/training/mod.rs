//! The training runs of all nets, and publishing their weights.
//!
//! Each net has a module with its settings and a function that trains it; `training_run` stores a run in a folder.

pub mod dqn;
pub mod dynamics;
mod labelled_scenes;
pub mod paths;
pub mod publish;
pub mod settings;
pub mod success;
pub mod training_run;
