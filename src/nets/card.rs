//! The card of weights: the settings that they were trained with. `weights` stores it as JSON in the file's metadata.

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
    /// Checks that weights of this fold have not seen the test tasks of the requested fold.
    ///
    /// # Errors
    ///
    /// If the folds differ.
    pub fn check(self, asked: FoldId) -> Result<(), OtherFold> {
        if self == asked { Ok(()) } else { Err(OtherFold { trained_on: self, asked }) }
    }
}

/// The settings that the weights were trained with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Card {
    /// What the nets must generalise to.
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
    /// Whether half of the samples were mirrored left to right.
    pub mirror: bool,
    /// Whether the fold's dev tasks were left out of training, so that settings can be chosen on them; false by
    /// default.
    #[serde(default)]
    pub without_dev: bool,
    /// Number of solutions trained on.
    pub samples: usize,
    /// Number of tasks that the solutions belong to.
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
    /// The highest learning rate.
    pub learning_rate: f64,
    /// Number of labelled balls that the batches are drawn from.
    pub balls: usize,
}

/// The optimiser of a training run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Optimiser {
    /// Adam (Kingma and Ba 2014).
    #[default]
    Adam,
    /// Muon (Jordan et al. 2024) for the weights of the layers, Adam for all other parameters.
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

/// The weights of the imagined paths in the loss of a dynamics net.
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

/// The scenes that a dynamics net has learned from, it and the nets that it started from or that proposed its balls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LearnedFrom {
    /// Random scenes alone.
    RandomScenes,
    /// Unlisted tasks of all templates, and perhaps random scenes.
    UnlistedTasks,
    /// Tasks of the benchmark, and perhaps others.
    #[default]
    Tasks,
}

impl DynamicsCard {
    /// Returns whether the net has seen dev tasks of its fold.
    pub fn has_seen_dev(&self) -> bool {
        self.learned_from == LearnedFrom::Tasks && !self.without_dev
    }
}

impl LearnedFrom {
    /// Whether such a net has seen nothing that any fold of this setup tests on, so that one net serves all its folds.
    pub fn serves_all_folds(self, setup: Setup) -> bool {
        match self {
            LearnedFrom::RandomScenes => true,
            LearnedFrom::UnlistedTasks => setup == Setup::Within,
            LearnedFrom::Tasks => false,
        }
    }

    fn is_tasks(&self) -> bool {
        *self == LearnedFrom::Tasks
    }
}

/// The settings that a dynamics net was trained with. It has seen the same tasks as the nets, or none: see
/// `learned_from`.
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
    /// Number of these balls whose paths are learned.
    pub imagined_per_scene: u16,
    /// The optimiser.
    #[serde(default, skip_serializing_if = "Optimiser::is_adam")]
    pub optimiser: Optimiser,
    /// The highest learning rate.
    pub learning_rate: f64,
    /// The weights of the paths in the loss.
    #[serde(default, skip_serializing_if = "PathWeights::is_default")]
    pub path_weights: PathWeights,
    /// Number of labelled balls that the batches are drawn from.
    pub balls: usize,
    /// Number of scenes that are unlisted tasks: laid out by a template's script, not listed by the benchmark. If it
    /// started from a net that had learned from more of them, their number.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub unlisted: usize,
    /// Number of random scenes, which belong to no task, counted in the same way.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub random_scenes: usize,
    /// The scenes that it has learned from, including those of the nets that it started from.
    #[serde(default, skip_serializing_if = "LearnedFrom::is_tasks")]
    pub learned_from: LearnedFrom,
    /// Whether the fold's dev tasks were left out, whatever the four nets have seen.
    #[serde(default)]
    pub without_dev: bool,
    /// SHA-256 of the weights whose dynamics net training started from, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
}

/// The settings that DQN was trained with: the card of its own weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DqnCard {
    /// What the net must generalise to.
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
    /// The highest learning rate.
    pub learning_rate: f64,
    /// Number of labelled balls that the batches are drawn from.
    pub balls: usize,
    /// Whether the fold's dev tasks were left out of training, so that settings can be chosen on them.
    pub without_dev: bool,
}

impl DqnCard {
    /// Returns the fold that the net was trained on.
    pub fn fold_id(&self) -> FoldId {
        FoldId { setup: self.setup, fold: self.fold }
    }
}
