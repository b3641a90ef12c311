//! What nets learn from: the search for solutions, balls labelled with their outcome, variants of scenes, and training
//! images.
//!
//! Uses the simulator, but neither nets nor files.

pub mod labels;
pub mod samples;
pub mod sampling;
pub mod scene_variants;
pub mod solutions;
