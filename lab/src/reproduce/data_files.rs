//! The data that all results learn from.

use std::path::{Path, PathBuf};

use anyhow::ensure;

use super::result_settings::Hyperparameters;
use crate::data::label::read_labels;
use crate::data::task_selection::TaskSelection;

/// The input files of a result; read only.
pub struct DataFiles {
    pub solutions: PathBuf,
    pub labels: PathBuf,
    pub variants: PathBuf,
}

impl DataFiles {
    /// Checks that the labelled balls are those of the hyperparameters. Returns the tasks that they are of.
    ///
    /// # Errors
    /// If they are not, or cannot be read.
    pub fn check(&self, hyperparameters: &Hyperparameters) -> anyhow::Result<TaskSelection> {
        let &Hyperparameters { label_rounds, variant_rounds, .. } = hyperparameters;
        let read = |path: &Path, rounds: u16, option: &str, variants: bool| {
            let labelled = read_labels(path)?;
            ensure!(
                labelled.variants == variants && !labelled.proposed && !labelled.random_scenes,
                "{} holds other balls than --{option}s takes: it takes those that `pathlight-lab data label{}` sampled",
                path.display(),
                if variants { " --variants" } else { "" },
            );
            ensure!(
                labelled.rounds() == Some(rounds.into()),
                "{} does not hold the balls of {rounds} rounds: run `pathlight-lab reproduce --only data`, or change \
             --{option}-rounds",
                path.display(),
            );
            Ok(labelled.selection)
        };
        let selection = read(&self.labels, label_rounds, "label", false)?;
        read(&self.variants, variant_rounds, "variant", true)?;
        Ok(selection)
    }
}
