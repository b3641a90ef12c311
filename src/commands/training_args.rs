//! The arguments that the commands that train share.

use std::path::PathBuf;

use clap::builder::{RangedU64ValueParser, TypedValueParser};

/// How to train, and where the run is kept; part of the arguments of other commands.
#[derive(clap::Args)]
pub struct TrainingArgs {
    /// Folder of the run: checkpoint, losses.csv, weights.safetensors [default: target/train/SETUP-FOLD for train,
    /// and judge, dynamics or dqn in it for the others]
    #[arg(long)]
    pub out: Option<PathBuf>,

    /// Samples per batch for train, scenes per batch for the others
    #[arg(long, default_value_t = 32, value_parser = clap::value_parser!(u16).range(1..))]
    pub batch: u16,

    /// Highest learning rate of Adam
    #[arg(long, default_value_t = 3e-3)]
    pub learning_rate: f64,

    /// Batches between two checkpoints, and between two lines of losses.csv
    #[arg(long, value_name = "BATCHES", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..))]
    pub checkpoint: u16,

    /// Stop at the first checkpoint after this many batches; the same command continues from there
    #[arg(long, value_name = "BATCHES")]
    pub stop_after: Option<usize>,

    /// Seed of the initial weights, and of the order of the samples or scenes
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
}

/// Numbers of epochs on the command line: without an epoch nothing would be trained.
pub fn epochs() -> impl TypedValueParser<Value = usize> {
    RangedU64ValueParser::new().range(1..)
}
