//! The arguments that all trainings share.

use std::path::PathBuf;

use pathlight_lab::training::settings::{LabelsRecipe, RunSettings};

use super::at_least_one::at_least_one;
use super::optimiser_arg::OptimiserName;

/// How to train, and where the run is kept.
#[derive(clap::Args)]
pub struct RunArgs {
    /// Folder of the run: checkpoint, losses.csv, weights.safetensors [default: target/train/SETUP-FOLD for the four
    /// nets, and success, dynamics or dqn in it for the others]
    #[arg(long)]
    out: Option<PathBuf>,

    /// Samples per batch for the four nets, scenes per batch for the others
    #[arg(long, default_value_t = LabelsRecipe::default().batch, value_parser = at_least_one())]
    pub batch: u16,

    /// Highest learning rate
    #[arg(long, default_value_t = LabelsRecipe::default().learning_rate, value_parser = learning_rate)]
    pub learning_rate: f64,

    /// Batches between two checkpoints, and between two lines of losses.csv
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

    /// Seed of the initial weights, and of the order of the samples or scenes
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

/// Parses a learning rate: with 0 nothing would be learned.
fn learning_rate(text: &str) -> Result<f64, String> {
    let rate = text.parse::<f64>().ok().filter(|rate| rate.is_finite() && *rate > 0.0);
    rate.ok_or_else(|| "give a number above 0, like 0.001".to_string())
}
