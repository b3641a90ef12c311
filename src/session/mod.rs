//! One session on one puzzle: what is played and whether it may be, the attempts of player and model, and an agent's
//! turn.

pub mod ending;
pub mod game;
pub mod moments;
pub mod puzzle;
pub mod scene_check;
#[cfg(feature = "nets")]
pub mod turn;
