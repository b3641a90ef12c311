//! How the nets of the main results are trained.

use pathlight::benchmark::folds::Setup;
use pathlight::nets::{Optimiser, PathWeights};

use crate::training::dynamics::DynamicsRecipe;
use crate::training::settings::LabelsRecipe;
use crate::training::{dqn, dynamics, success};

/// The recipes of the nets of a fold that agents are measured with.
pub struct Recipes {
    pub success: LabelsRecipe,
    pub dynamics: DynamicsRecipe,
    pub dqn: LabelsRecipe,
}

impl Recipes {
    /// The recipes of a setup, chosen on the dev tasks of its fold 0 (docs/experiments.md). The success net and the
    /// dynamics net are trained alike, so the difference between them shows what imagining brings.
    pub fn of(setup: Setup) -> Recipes {
        let success = LabelsRecipe { optimiser: Optimiser::Muon, ..success::Settings::default().recipe };
        let LabelsRecipe { batch, optimiser, learning_rate, balls_per_scene } = success;
        let path_weights = match setup {
            Setup::Within => PathWeights::default(),
            Setup::Cross => PathWeights { all: 2.0, solving: 4.0 },
        };
        let dynamics = DynamicsRecipe {
            batch,
            optimiser,
            learning_rate,
            balls_per_scene,
            path_weights,
            ..dynamics::Settings::default().recipe
        };
        // Smaller batches than those of the other nets, so that a short training has more steps.
        let dqn = LabelsRecipe { batch: 16, ..dqn::Settings::default().recipe };
        Recipes { success, dynamics, dqn }
    }
}
