//! Settings shared by the training commands.
//!
//! A recipe, the data, the epochs and the seed determine the weights. The card of the weights records the recipe too.

use std::path::PathBuf;

use pathlight::nets::Optimiser;

/// Seed and files of a run.
#[derive(Clone, Debug)]
pub struct RunSettings {
    /// Folder of the run: checkpoint, losses.csv, weights.safetensors; `None` means the default folder of the fold.
    pub out: Option<PathBuf>,
    /// Batches between checkpoints, and between lines of losses.csv.
    pub checkpoint: u16,
    /// Stop at the first checkpoint after this many batches.
    pub stop_after: Option<usize>,
    /// Seed of the initial weights and of the order of the samples or scenes.
    pub seed: u64,
}

impl Default for RunSettings {
    fn default() -> RunSettings {
        RunSettings { out: None, checkpoint: 100, stop_after: None, seed: 0 }
    }
}

/// Default number of samples or scenes per batch.
pub const BATCH: u16 = 32;
/// Default peak learning rate.
pub const LEARNING_RATE: f64 = 3e-3;

/// How the four nets are trained.
#[derive(Clone, Debug, PartialEq)]
pub struct PathsRecipe {
    /// Samples per batch.
    pub batch: u16,
    /// Learning rate of Adam before it decays.
    pub learning_rate: f64,
    /// Number of final epochs over which the learning rate decays linearly to zero.
    pub decay_epochs: usize,
    /// Mirror half of the samples left to right; PHYRE's world is symmetric.
    pub mirror: bool,
    /// Train without the dev tasks, so that settings can be chosen on them.
    pub without_dev: bool,
}

impl Default for PathsRecipe {
    fn default() -> PathsRecipe {
        PathsRecipe { batch: BATCH, learning_rate: LEARNING_RATE, decay_epochs: 1, mirror: false, without_dev: false }
    }
}

/// How a net that learns from labelled balls is trained.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelsRecipe {
    /// Scenes per batch.
    pub batch: u16,
    pub optimiser: Optimiser,
    /// Peak learning rate.
    pub learning_rate: f64,
    /// Balls per scene in a batch, resampled for each batch.
    pub balls_per_scene: u16,
}

impl Default for LabelsRecipe {
    fn default() -> LabelsRecipe {
        LabelsRecipe { batch: BATCH, optimiser: Optimiser::Adam, learning_rate: LEARNING_RATE, balls_per_scene: 256 }
    }
}
