//! Parts shared by the command lines of the player and of the lab: arguments, exit codes, progress, and files that are
//! written completely or not at all. Intended for these two programs only; it may change at any time.

pub mod agent_arg;
pub mod engine_arg;
pub mod exit;
pub mod fold_args;
pub mod progress;
pub mod replace_file;
pub mod template_arg;
pub mod weights_file;
