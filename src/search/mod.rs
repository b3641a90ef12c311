//! Searches over many balls: the solutions of a scene, the map of all solutions at one radius, and whether a solution
//! was luck.

pub mod luck;
pub mod solution_search;
pub mod solve_map;
pub mod stability;
