//! The settings that the trainings share.
//!
//! A recipe, with data, epochs and seed, decides the weights. The card of weights has its fields too.

use std::path::PathBuf;

use pathlight::nets::Optimiser;

/// Seed and files of a run.
#[derive(Clone, Debug)]
pub struct RunSettings {
    /// Folder of the run: checkpoint, losses.csv, weights.safetensors; `None` is the default one of the fold.
    pub out: Option<PathBuf>,
    /// Batches between two checkpoints, and between two lines of losses.csv.
    pub checkpoint: u16,
    /// Stop at the first checkpoint after this many batches.
    pub stop_after: Option<usize>,
    /// Seed of the initial weights, and of the order of the samples or scenes.
    pub seed: u64,
}

impl Default for RunSettings {
    fn default() -> RunSettings {
        RunSettings { out: None, checkpoint: 100, stop_after: None, seed: 0 }
    }
}

/// How the four nets are trained.
#[derive(Clone, Debug, PartialEq)]
pub struct PathsRecipe {
    /// Samples per batch.
    pub batch: u16,
    /// Learning rate of Adam before it decays.
    pub learning_rate: f64,
    /// Number of final epochs over which the learning rate decays linearly to zero.
    pub decay_epochs: usize,
    /// Show half of the samples mirrored left to right: PHYRE's world is symmetric.
    pub mirror: bool,
    /// Leave the dev tasks out of training, so that settings can be chosen on them.
    pub without_dev: bool,
}

impl Default for PathsRecipe {
    fn default() -> PathsRecipe {
        PathsRecipe { batch: 32, learning_rate: 3e-3, decay_epochs: 1, mirror: false, without_dev: false }
    }
}

/// How a net that learns from labelled balls is trained.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelsRecipe {
    /// Scenes per batch.
    pub batch: u16,
    /// The optimiser.
    pub optimiser: Optimiser,
    /// Its highest learning rate.
    pub learning_rate: f64,
    /// Balls of each scene in a batch, sampled anew each time.
    pub balls_per_scene: u16,
}

impl Default for LabelsRecipe {
    fn default() -> LabelsRecipe {
        LabelsRecipe { batch: 32, optimiser: Optimiser::Adam, learning_rate: 3e-3, balls_per_scene: 256 }
    }
}
