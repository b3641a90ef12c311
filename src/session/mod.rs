//! One session on one puzzle: what is played and whether it may be, an agent's turn, and how a rollout ended.

pub mod ending;
pub mod puzzle;
pub mod scene_check;
#[cfg(feature = "nets")]
pub mod turn;
