//! One session on one puzzle: the puzzle and whether it can be played, an agent's turn, and the end of a rollout.

pub mod ending;
pub mod puzzle;
pub mod scene_check;
#[cfg(feature = "nets")]
pub mod turn;
