//! Training of the nets; native only. Used by the commands that train and by the benches.

mod adam;
mod dqn;
mod dynamics;
mod schedule;
mod trainer;

pub use dqn::DqnBatch;
pub use dynamics::DynamicsBatch;
pub use schedule::{Schedule, WARMUP_STEPS};
pub use trainer::{Batch, CheckpointError, JudgeBatch, Trainable, Trainer};
