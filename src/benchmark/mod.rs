//! PHYRE's benchmark: which tasks train and test an agent (`folds`), how it is scored (`auccess`), and how hard the
//! tasks are (`difficulty`).

pub mod auccess;
pub mod difficulty;
pub mod folds;
