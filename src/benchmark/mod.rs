//! PHYRE's benchmark: which tasks train and test an agent (`folds`), how it is scored (`auccess`), how hard the tasks
//! are (`difficulty`), the actions that its baselines choose from (`action_list`), and what its simulator returns
//! (`observation`).

pub mod action_list;
pub mod auccess;
pub mod difficulty;
pub mod folds;
pub mod observation;
