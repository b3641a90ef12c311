//! One session on one puzzle: the game, the map of all solutions, and how well imagined paths agree with real ones.

pub mod game;
pub mod soft_iou;
pub mod solve_map;
