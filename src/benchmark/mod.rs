//! PHYRE's benchmark: its training and test tasks (`folds`), its score (`auccess`), the difficulty of its tasks
//! (`difficulty`), the actions that its baselines choose from (`action_list`), and the output of its simulator
//! (`observation`).

pub mod action_list;
pub mod auccess;
pub mod difficulty;
pub mod folds;
pub mod observation;
