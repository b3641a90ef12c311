//! The settings that a result is made with, and whether results are comparable.

use pathlight::agents;
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use super::data_files::DataFiles;
use crate::files::differences::differences;
use crate::files::digest;
use crate::training::dynamics::{self, DynamicsRecipe};
use crate::training::settings::{LabelsRecipe, PathsRecipe};
use crate::training::{dqn, paths, success};

/// Settings that can be chosen for a table. The defaults are those of the results in the repository. Aliases: keys of
/// older files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hyperparameters {
    /// Seed of training and evaluation.
    pub seed: u64,
    /// Rounds of labelling; every task tries 64 balls per round.
    pub label_rounds: u16,
    /// Rounds of labelling variants of the scenes, another variant of each task and 64 balls per round.
    pub variant_rounds: u16,
    /// Epochs of the four nets.
    pub epochs: u16,
    /// Epochs of the success net in the setup within.
    #[serde(alias = "judge_epochs")]
    pub success_epochs: u16,
    /// Epochs of the success net in the setup cross.
    #[serde(alias = "judge_epochs_cross")]
    pub success_epochs_cross: u16,
    /// Epochs of the dynamics net, over scenes and variants.
    pub dynamics_epochs: u16,
    /// Rounds of labelling the balls that the dynamics net then finds likeliest: hard negatives. Older rows have none.
    #[serde(default)]
    pub hard_negative_rounds: u16,
    /// Further epochs of the dynamics net, on these too.
    #[serde(default)]
    pub hard_negative_epochs: u16,
    /// Epochs of DQN.
    pub dqn_epochs: u16,
    /// At most the first test tasks of each template.
    pub limit: u16,
}

impl Default for Hyperparameters {
    fn default() -> Hyperparameters {
        Hyperparameters {
            seed: 0,
            label_rounds: 15,
            variant_rounds: 4,
            epochs: 10,
            success_epochs: 150,
            success_epochs_cross: 60,
            dynamics_epochs: 12,
            hard_negative_rounds: 2,
            hard_negative_epochs: 12,
            dqn_epochs: 15,
            limit: 100,
        }
    }
}

/// What determines a result, apart from its setup and fold. Results belong in one table if these agree.
#[derive(PartialEq, Serialize)]
pub struct ResultSettings {
    #[serde(flatten)]
    pub hyperparameters: Hyperparameters,
    pub simulator: u32,
    pub agents_version: u32,
    /// SHA-256 of the file of solutions.
    pub solutions: String,
    /// SHA-256 of the file of labelled balls.
    pub labels: String,
    /// SHA-256 of the files that the dynamics net learns from: that, and the balls in variants.
    pub labels_and_variants: String,
    #[serde(flatten)]
    pub recipes: Recipes,
}

/// How the nets of a result are trained.
#[derive(PartialEq, Serialize)]
pub struct Recipes {
    pub nets: PathsRecipe,
    pub success: Option<LabelsRecipe>,
    pub dynamics: Option<DynamicsRecipe>,
    pub hard_negatives: Option<DynamicsRecipe>,
    pub dqn: LabelsRecipe,
}

impl Recipes {
    /// The recipes of a result made now.
    pub fn of(hyperparameters: &Hyperparameters) -> Recipes {
        let dynamics = dynamics::Settings::default().recipe;
        let further = DynamicsRecipe { learning_rate: 2e-3, ..dynamics.clone() };
        Recipes {
            nets: paths::Settings::default().recipe,
            success: Some(success::Settings::default().recipe),
            dynamics: Some(dynamics),
            hard_negatives: (hyperparameters.hard_negative_rounds > 0).then_some(further),
            // Smaller batches than those of the other nets, so that a short training has more steps.
            dqn: LabelsRecipe { batch: 16, ..dqn::Settings::default().recipe },
        }
    }
}

impl ResultSettings {
    /// The settings of a result made now.
    ///
    /// # Errors
    /// If the data cannot be read.
    pub fn expected(hyperparameters: &Hyperparameters, data: &DataFiles) -> anyhow::Result<ResultSettings> {
        let labels = digest(&data.labels)?;
        Ok(ResultSettings {
            hyperparameters: hyperparameters.clone(),
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            solutions: digest(&data.solutions)?,
            labels_and_variants: format!("{labels} {}", digest(&data.variants)?),
            labels,
            recipes: Recipes::of(hyperparameters),
        })
    }

    /// Returns these settings as those of today, if only the version of the agents is older: from 3 to 4 the paper's
    /// agent alone has changed, whose newer results stand apart (`measure paper`).
    pub fn of_today(mut self) -> ResultSettings {
        if self.agents_version == 3 {
            self.agents_version = 4;
        }
        self
    }

    /// Names the settings that differ; empty if none do.
    pub fn differences(&self, other: &ResultSettings) -> String {
        differences(self, other)
    }
}
