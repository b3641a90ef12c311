//! One session on one puzzle: what is played, the game, an agent's turn, attempts that can be verified, whether a
//! solution was luck, the map of all solutions and the search for them, and the agreement of predicted with simulated
//! paths.

pub mod ending;
pub mod game;
pub mod luck;
pub mod played;
pub mod scene_check;
pub mod soft_iou;
pub mod solution_search;
pub mod solve_map;
pub mod turn;
pub mod verification;
