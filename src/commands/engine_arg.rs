//! The argument that names the engine; the lab's binary takes it too.

use pathlight::simulator::Engine;

#[derive(clap::Args)]
pub struct EngineArg {
    /// Engine to simulate with: box2d, the port of Box2D's step, or rapier, rapier2d's own pipeline as a second opinion
    #[arg(long, default_value_t)]
    pub engine: Engine,
}
