//! The argument that selects the engine; used by the lab's binary too.

use crate::simulator::Engine;

#[derive(clap::Args)]
pub struct EngineArg {
    /// Engine to simulate with: box2d, PHYRE's Box2D, or rapier, rapier2d's own pipeline as a second opinion
    #[arg(long, default_value_t)]
    pub engine: Engine,
}
