//! The card of weights: the settings that they were trained with. `weights` keeps it in the file's metadata as JSON.

use std::fmt::{self, Display, Formatter};

use serde::{Deserialize, Serialize};

use crate::benchmark::folds::{FoldId, Setup};

/// Weights that were trained on a fold other than the one whose test tasks they are to solve.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the weights were trained on {0} {1}, so they may have seen the test tasks of {2} {3}: use weights of {2} {3}",
    .trained_on.setup, .trained_on.fold, .asked.setup, .asked.fold
)]
pub struct OtherFold {
    trained_on: FoldId,
    asked: FoldId,
}

impl FoldId {
    /// Checks that weights of this fold have not seen the test tasks of the fold that is asked for.
    ///
    /// # Errors
    /// If the folds differ.
    pub fn check(self, asked: FoldId) -> Result<(), OtherFold> {
        if self == asked { Ok(()) } else { Err(OtherFold { trained_on: self, asked }) }
    }
}

/// The settings that the weights were trained with. Aliases: keys of older files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Card {
    /// What the fold generalises to.
    pub setup: Setup,
    /// 0..=9; the nets have seen only this fold's training tasks.
    pub fold: u8,
    /// Seed of the initial weights and of the order of the samples.
    pub seed: u64,
    /// Passes over the samples.
    pub epochs: usize,
    /// Samples per batch.
    pub batch: u16,
    /// Learning rate of Adam before it decays.
    pub learning_rate: f64,
    /// Number of final epochs over which the learning rate decays linearly to zero.
    pub decay_epochs: usize,
    /// Half of the samples were mirrored left to right.
    pub mirror: bool,
    /// The fold's dev tasks were left out of training, so that settings may be chosen on them; false by default.
    #[serde(default)]
    pub without_dev: bool,
    /// Solutions trained on.
    pub samples: usize,
    /// Tasks that the solutions belong to.
    pub tasks: usize,
    /// `simulator::VERSION` of the rollouts trained on.
    pub simulator: u32,
    /// The settings of the success net's training, if there is a success net.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub success: Option<SuccessCard>,
    /// The settings of the dynamics net's training, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dynamics: Option<DynamicsCard>,
}

impl Card {
    /// Returns the fold that the nets were trained on.
    pub fn fold_id(&self) -> FoldId {
        FoldId { setup: self.setup, fold: self.fold }
    }
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// The settings that a success net was trained with. It has seen the same tasks as the nets.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SuccessCard {
    /// Seed of the initial weights and of the order of the scenes.
    pub seed: u64,
    /// Passes over the scenes.
    pub epochs: usize,
    /// Scenes per batch.
    pub batch: u16,
    /// Balls drawn per scene in a batch.
    pub balls_per_scene: u16,
    /// The optimiser.
    #[serde(default, skip_serializing_if = "Optimiser::is_adam")]
    pub optimiser: Optimiser,
    /// Its highest learning rate.
    pub learning_rate: f64,
    /// Labelled balls that these are drawn from.
    pub balls: usize,
}

/// The optimiser of a training.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Optimiser {
    /// Adam (Kingma and Ba 2014).
    #[default]
    Adam,
    /// Muon (Jordan et al. 2024) for the weights of the layers, Adam for all else.
    Muon,
}

impl Optimiser {
    fn is_adam(&self) -> bool {
        *self == Optimiser::Adam
    }
}

impl Display for Optimiser {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(match self {
            Optimiser::Adam => "Adam",
            Optimiser::Muon => "Muon",
        })
    }
}

/// How much the imagined paths count in the loss of a dynamics net.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathWeights {
    /// Weight of the mean distance between imagined and real coordinates, in `ball_head::UNIT`.
    pub all: f64,
    /// Weight of the paths of a ball that solves, and of their expected errors, relative to those of other balls.
    pub solving: f64,
}

impl PathWeights {
    fn is_default(&self) -> bool {
        *self == PathWeights::default()
    }
}

impl Default for PathWeights {
    fn default() -> PathWeights {
        PathWeights { all: 0.5, solving: 1.0 }
    }
}

/// The settings that a dynamics net was trained with. It has seen the same tasks as the nets, or none: see
/// `random_scenes_alone`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DynamicsCard {
    /// Seed of the initial weights and of the order of the scenes.
    pub seed: u64,
    /// Passes over the scenes.
    pub epochs: usize,
    /// Scenes per batch.
    pub batch: u16,
    /// Balls drawn per scene in a batch.
    pub balls_per_scene: u16,
    /// Of these, balls whose paths are learned.
    pub imagined_per_scene: u16,
    /// The optimiser.
    #[serde(default, skip_serializing_if = "Optimiser::is_adam")]
    pub optimiser: Optimiser,
    /// Its highest learning rate.
    pub learning_rate: f64,
    /// How much the paths count in its loss.
    #[serde(default, skip_serializing_if = "PathWeights::is_default")]
    pub path_weights: PathWeights,
    /// Labelled balls that these are drawn from.
    pub balls: usize,
    /// Whether the net sees the covered share of each cell. Older ones saw which cells are set; `PathNet::load` refuses
    /// them.
    #[serde(default)]
    pub coverage: bool,
    /// How many of the scenes are variants of the tasks' scenes.
    #[serde(default)]
    pub variants: usize,
    /// How many of the scenes are blends of two tasks' scenes.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub blends: usize,
    /// How many of the scenes are unlisted tasks: laid out by a template's script, not listed by the benchmark.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub unlisted: usize,
    /// How many of the scenes are random ones, of no task.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub random_scenes: usize,
    /// It has seen random scenes alone and no task, so nets of any fold may start from it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub random_scenes_alone: bool,
    /// The fold's dev tasks were left out, whatever the four nets have seen.
    #[serde(default)]
    pub without_dev: bool,
    /// The net learned chances alone: what it imagines are no paths.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub without_paths: bool,
    /// SHA-256 of the weights whose dynamics net it started from, if it did.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
}

/// The settings that DQN was trained with: the card of its own weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DqnCard {
    /// What the fold generalises to.
    pub setup: Setup,
    /// 0..=9; the net has seen only this fold's training tasks.
    pub fold: u8,
    /// Seed of the initial weights and of the order of the scenes.
    pub seed: u64,
    /// Passes over the scenes.
    pub epochs: usize,
    /// Scenes per batch.
    pub batch: u16,
    /// Balls drawn per scene in a batch, half of them solutions.
    pub balls_per_scene: u16,
    /// The optimiser.
    #[serde(default, skip_serializing_if = "Optimiser::is_adam")]
    pub optimiser: Optimiser,
    /// Its highest learning rate.
    pub learning_rate: f64,
    /// Labelled balls that these are drawn from.
    pub balls: usize,
    /// How many of the scenes are variants of the tasks' scenes.
    pub variants: usize,
    /// The fold's dev tasks were left out of training, so that settings may be chosen on them.
    pub without_dev: bool,
}

impl DqnCard {
    /// Returns the fold that the net was trained on.
    pub fn fold_id(&self) -> FoldId {
        FoldId { setup: self.setup, fold: self.fold }
    }
}
