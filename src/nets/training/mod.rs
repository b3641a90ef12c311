//! Training of the nets, with the feature `training`; native only. Used by the lab.

mod adam;
mod cross_entropy;
mod dqn;
mod dynamics;
mod muon;
mod sample;
mod schedule;
mod trainer;

pub use dqn::DqnBatch;
pub use dynamics::DynamicsBatch;
pub use sample::Sample;
pub use schedule::{Schedule, WARMUP_STEPS};
pub use trainer::{Batch, CheckpointError, SuccessBatch, Trainable, Trainer};
