//! Training of the nets, with the feature `training`; native only. Used by the lab.

mod adam;
mod cross_entropy;
mod dqn;
mod dynamics;
mod muon;
mod paths;
mod schedule;
mod success;
mod trainer;

pub use dqn::DqnBatch;
pub use dynamics::DynamicsBatch;
pub use paths::{PathsBatch, Sample};
pub use schedule::{Schedule, WARMUP_STEPS};
pub use success::SuccessBatch;
pub use trainer::{CheckpointError, Trainable, Trainer};
