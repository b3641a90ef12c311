//! PHYRE's benchmark: which tasks train and test an agent (`folds`), and how it is scored (`auccess`).

pub mod auccess;
pub mod folds;
