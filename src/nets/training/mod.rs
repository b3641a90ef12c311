//! Training of the nets; native only. Used by the commands that train and by the benches.

mod adam;
mod trainer;

pub use trainer::{Batch, JudgeBatch, Module, Trainer};
