//! The result of one setup and fold: its JSON file, the settings that it was made with, and whether results are
//! comparable.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::agents;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::DqnCard;
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use crate::files::differences::differences;
use crate::files::digest;
use crate::files::replace_file::replace_file;
use crate::measure::report::Report;
use crate::training::dynamics::{self, DynamicsRecipe};
use crate::training::settings::{LabelsRecipe, PathsRecipe, recipe_of};
use crate::training::training_run::Checkpoint;
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
    /// Epochs of DQN.
    pub dqn_epochs: u16,
    /// Use only the first N test tasks of each template.
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
            dqn_epochs: 15,
            limit: 100,
        }
    }
}

/// The input files of a result; read only.
pub struct DataFiles {
    pub solutions: PathBuf,
    pub labels: PathBuf,
    pub variants: PathBuf,
}

/// The result of a setup and fold. Aliases: keys of older files.
#[derive(Serialize, Deserialize)]
pub struct FoldResult {
    pub hyperparameters: Hyperparameters,
    /// The training of the four nets.
    pub nets: Checkpoint,
    /// The training of the success net.
    #[serde(alias = "judge")]
    pub success: Checkpoint,
    /// The training of the dynamics net, which starts from the success net.
    pub dynamics: Checkpoint,
    /// The training of DQN.
    pub dqn: Checkpoint<DqnCard>,
    /// Size of the weights of the four nets and the dynamics net, bytes.
    pub weights: u64,
    /// Size of DQN's weights, bytes.
    pub dqn_weights: u64,
    /// Wall-clock time of the evaluation of all agents, s.
    pub evaluation_seconds: f64,
    /// Threads that it was made with.
    pub threads: usize,
    pub report: Report,
}

/// What determines a result, apart from its setup and fold. Results belong in one table if these agree.
#[derive(PartialEq, Serialize)]
pub struct ResultSettings {
    #[serde(flatten)]
    hyperparameters: Hyperparameters,
    simulator: u32,
    agents_version: u32,
    /// SHA-256 of the file of solutions.
    solutions: String,
    /// SHA-256 of the file of labelled balls.
    labels: String,
    /// SHA-256 of the files that the dynamics net learns from: that, and the balls in variants.
    labels_and_variants: String,
    #[serde(flatten)]
    recipes: Recipes,
}

/// How the nets of a result are trained.
#[derive(PartialEq, Serialize)]
pub struct Recipes {
    pub nets: PathsRecipe,
    pub success: Option<LabelsRecipe>,
    pub dynamics: Option<DynamicsRecipe>,
    pub dqn: LabelsRecipe,
}

impl Default for Recipes {
    fn default() -> Recipes {
        Recipes {
            nets: paths::Settings::default().recipe,
            success: Some(success::Settings::default().recipe),
            dynamics: Some(dynamics::Settings::default().recipe),
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
        let digest = |path: &Path| digest(path).context("run `pathlight-lab reproduce --only data` first");
        let labels = digest(&data.labels)?;
        Ok(ResultSettings {
            hyperparameters: hyperparameters.clone(),
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            solutions: digest(&data.solutions)?,
            labels_and_variants: format!("{labels} {}", digest(&data.variants)?),
            labels,
            recipes: Recipes::default(),
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

impl FoldResult {
    /// Reads the result of a fold; `None` if there is no file.
    ///
    /// # Errors
    /// If the file is not a result, or the result of another fold.
    pub fn load(path: &Path, fold: FoldId) -> anyhow::Result<Option<FoldResult>> {
        let name = path.display();
        let bytes = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            read => read.with_context(|| format!("cannot read {name}"))?,
        };
        let result: FoldResult = serde_json::from_slice(&bytes)
            .with_context(|| format!("{name} is not a result of `pathlight-lab reproduce`: remove it"))?;
        let found = result.report.fold_id();
        ensure!(
            found == fold,
            "{name} holds the result of {} {}: remove it, or name it after that fold",
            found.setup,
            found.fold
        );
        Ok(Some(result))
    }

    /// Writes the file, completely or not at all.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn save(&self, path: &Path) -> anyhow::Result<()> {
        replace_file(path, &serde_json::to_vec(self)?)
    }

    /// The settings it was made with.
    pub fn settings(&self) -> ResultSettings {
        ResultSettings {
            hyperparameters: self.hyperparameters.clone(),
            simulator: self.report.simulator,
            agents_version: self.report.agents_version,
            solutions: self.nets.data.clone(),
            labels: self.success.data.clone(),
            labels_and_variants: self.dynamics.data.clone(),
            recipes: Recipes {
                nets: recipe_of(&self.nets.card),
                success: self.success.card.success.as_ref().map(recipe_of),
                dynamics: self.dynamics.card.dynamics.as_ref().map(recipe_of),
                dqn: recipe_of(&self.dqn.card),
            },
        }
    }
}

/// Reads the first result in a folder, and returns it with its file; `None` if there is none.
///
/// # Errors
/// If its file is damaged.
pub fn first(folder: &Path) -> anyhow::Result<Option<(PathBuf, FoldResult)>> {
    for fold in FoldId::all() {
        let path = folder.join(format!("{fold}.json"));
        if let Some(result) = FoldResult::load(&path, fold)? {
            return Ok(Some((path, result)));
        }
    }
    Ok(None)
}

/// Reads all results in a folder, within before cross, folds ascending.
///
/// # Errors
/// If there is none, a file is damaged, or results have different settings.
pub fn read(folder: &Path) -> anyhow::Result<Vec<FoldResult>> {
    let mut results: Vec<FoldResult> = Vec::new();
    for fold in FoldId::all() {
        let path = folder.join(format!("{fold}.json"));
        let Some(result) = FoldResult::load(&path, fold)? else { continue };
        if let Some(first) = results.first() {
            let other = result.settings().differences(&first.settings());
            ensure!(
                other.is_empty(),
                "{} was made with other settings than the results before it ({other}): keep such results in different \
                 folders (--results)",
                path.display()
            );
        }
        results.push(result);
    }
    ensure!(!results.is_empty(), "{} holds no results: run `pathlight-lab reproduce` first", folder.display());
    Ok(results)
}

#[cfg(test)]
mod tests {
    use pathlight::agents::agent_name::AgentName;

    use super::*;

    /// A result of the repository; its settings are today's defaults but for the data, which are not in it.
    #[test]
    fn rows_of_the_repository_were_made_with_the_settings_of_today() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results");
        let results = read(&folder).expect("the results agree");
        assert_eq!(results.len(), 20);
        let third = results[3].settings().of_today();
        let today = ResultSettings {
            hyperparameters: Hyperparameters::default(),
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            solutions: third.solutions.clone(),
            labels: third.labels.clone(),
            labels_and_variants: third.labels_and_variants.clone(),
            recipes: Recipes::default(),
        };
        assert_eq!(third.differences(&today), "");
        let written: FoldResult =
            serde_json::from_slice(&serde_json::to_vec(&results[3]).expect("plain data")).expect("a result");
        assert_eq!(written.settings().of_today().differences(&today), "", "a result that is written now is read alike");
    }

    #[test]
    fn a_row_with_the_old_names_of_the_success_net_is_read_alike() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results/cross-3.json");
        let text = fs::read_to_string(file).expect("a result");
        let old = ["\"", "_epochs\"", "_epochs_cross\""]
            .into_iter()
            .fold(text.clone(), |text, end| text.replace(&format!("\"success{end}"), &format!("\"judge{end}")));
        assert!(old.contains("\"judge_epochs_cross\":60") && !old.contains("\"success"));
        let [old, new] = [old, text].map(|text| serde_json::from_str::<FoldResult>(&text).expect("a result"));
        assert_eq!(old.settings().differences(&new.settings()), "");
        let score = |result: &FoldResult| result.report.score(AgentName::Success);
        assert!(score(&new).is_some());
        assert_eq!(score(&old), score(&new));
    }
}
