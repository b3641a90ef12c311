//! Arguments that several commands share, most of them for training.

use std::path::PathBuf;

use clap::ValueEnum;
use clap::builder::{RangedU64ValueParser, TypedValueParser};
use pathlight::nets::{Optimiser, PathWeights};
use pathlight_lab::training::settings::{BATCH, LEARNING_RATE, LabelsRecipe, RunSettings};

pub fn at_least_one() -> impl TypedValueParser<Value = u16> {
    clap::value_parser!(u16).range(1..)
}

/// Parses a count from 1 to 2^32 - 1. Counts are multiplied, so they need an upper bound too.
pub fn count() -> impl TypedValueParser<Value = usize> {
    RangedU64ValueParser::new().range(1..=u64::from(u32::MAX))
}

/// Parses a number of random scenes. It is bounded because a list of their ids is held in memory.
pub fn random_scenes() -> impl TypedValueParser<Value = u32> {
    clap::value_parser!(u32).range(1..=10_000_000)
}

/// How to train, and where to keep the run.
#[derive(clap::Args)]
pub struct RunArgs {
    /// Folder of the run: checkpoint, losses.csv, weights.safetensors [default: target/train/SETUP-FOLD for the four
    /// nets, and its subfolder success, dynamics or dqn for the other nets]
    #[arg(long)]
    out: Option<PathBuf>,

    /// Samples per batch for the four nets, scenes per batch for the other nets
    #[arg(long, default_value_t = BATCH, value_parser = at_least_one())]
    pub batch: u16,

    /// Peak learning rate
    #[arg(long, default_value_t = LEARNING_RATE, value_parser = positive)]
    pub learning_rate: f64,

    /// Batches between checkpoints, and between lines of losses.csv
    #[arg(
        long,
        value_name = "BATCHES",
        default_value_t = RunSettings::default().checkpoint,
        value_parser = at_least_one()
    )]
    checkpoint: u16,

    /// Stop at the first checkpoint after this many batches; the same command continues from there
    #[arg(long, value_name = "BATCHES")]
    stop_after: Option<usize>,

    /// Seed of the initial weights and of the order of the samples or scenes
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

impl RunArgs {
    pub fn labels_recipe(&self, optimiser: OptimiserName, balls_per_scene: u16) -> LabelsRecipe {
        LabelsRecipe {
            batch: self.batch,
            optimiser: optimiser.into(),
            learning_rate: self.learning_rate,
            balls_per_scene,
        }
    }
}

impl From<RunArgs> for RunSettings {
    fn from(RunArgs { out, checkpoint, stop_after, seed, .. }: RunArgs) -> RunSettings {
        RunSettings { out, checkpoint, stop_after, seed }
    }
}

/// Parses a learning rate or a weight. With zero, nothing would be learned.
fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "give a number above 0, like 0.001".to_string())
}

/// The name of an optimiser.
#[derive(Clone, Copy, Default, ValueEnum)]
pub enum OptimiserName {
    #[default]
    Adam,
    /// Muon for the weights of the layers, Adam for everything else; learns more in the same number of batches
    Muon,
}

impl From<OptimiserName> for Optimiser {
    fn from(name: OptimiserName) -> Optimiser {
        match name {
            OptimiserName::Adam => Optimiser::Adam,
            OptimiserName::Muon => Optimiser::Muon,
        }
    }
}

/// The weights of the paths in the loss.
#[derive(clap::Args)]
pub struct PathWeightsArgs {
    /// Weight of the paths in the loss
    #[arg(long, value_name = "W", default_value_t = PathWeights::default().all, value_parser = positive)]
    path_weight: f64,

    /// Weight of the paths of balls that solve, relative to those of other balls
    #[arg(long, value_name = "W", default_value_t = PathWeights::default().solving, value_parser = positive)]
    solving_path_weight: f64,
}

impl From<PathWeightsArgs> for PathWeights {
    fn from(args: PathWeightsArgs) -> PathWeights {
        PathWeights { all: args.path_weight, solving: args.solving_path_weight }
    }
}
