//! The result of one setup and fold: its JSON file, the settings that it was made with, and whether results are
//! comparable.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::agents;
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::nets::DqnCard;
use pathlight::puzzle::utf8::utf8;
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use super::recipes::Recipes;
use crate::files::differences::differences;
use crate::files::digest;
use crate::files::replace_file::replace_file;
use crate::measure::report::Report;
use crate::training::dynamics::DynamicsRecipe;
use crate::training::settings::{LabelsRecipe, recipe_of};
use crate::training::training_run::Checkpoint;

/// Settings that can be chosen for a table. The defaults are those of the results in the repository.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hyperparameters {
    /// Seed of training and evaluation.
    pub seed: u64,
    /// Rounds of labelling; every task tries 64 balls per round.
    pub label_rounds: u16,
    /// Epochs of the success net and of the dynamics net.
    pub epochs: u16,
    /// Epochs of DQN.
    pub dqn_epochs: u16,
    /// Use only the first N test tasks of each template.
    pub limit: u16,
}

impl Default for Hyperparameters {
    fn default() -> Hyperparameters {
        Hyperparameters { seed: 0, label_rounds: 10, epochs: 30, dqn_epochs: 15, limit: 100 }
    }
}

/// The input files of a result; read only.
pub struct DataFiles {
    pub solutions: PathBuf,
    pub labels: PathBuf,
}

/// The result of a setup and fold.
#[derive(Serialize, Deserialize)]
pub struct FoldResult {
    pub hyperparameters: Hyperparameters,
    /// SHA-256 of the file of solutions.
    pub solutions: String,
    /// The training of the success net.
    pub success: Checkpoint,
    /// The training of the dynamics net.
    pub dynamics: Checkpoint,
    /// The training of DQN.
    pub dqn: Checkpoint<DqnCard>,
    /// Wall-clock time of the evaluation of the agents, s; absent if they were evaluated in separate runs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub evaluation_seconds: Option<f64>,
    /// Threads that it was made with.
    pub threads: usize,
    pub report: Report,
}

/// What determines a result, apart from its fold. Results belong in one table if `differences` finds none.
pub struct ResultSettings {
    setup: Setup,
    shared: SharedSettings,
    nets: NetsSettings,
}

/// The settings that must be the same in both setups.
#[derive(Serialize)]
struct SharedSettings {
    #[serde(flatten)]
    hyperparameters: Hyperparameters,
    simulator: u32,
    agents_version: u32,
    /// SHA-256 of the file of solutions.
    solutions: String,
    /// SHA-256 of the file of labelled balls.
    labels: String,
}

/// How the nets of a setup are trained.
#[derive(Serialize)]
struct NetsSettings {
    success: NetSettings<LabelsRecipe>,
    dynamics: NetSettings<DynamicsRecipe>,
    dqn: NetSettings<LabelsRecipe>,
}

/// How a net is trained.
#[derive(Serialize)]
struct NetSettings<R> {
    seed: u64,
    epochs: usize,
    #[serde(flatten)]
    recipe: R,
}

impl ResultSettings {
    /// The settings of a result made now.
    ///
    /// # Errors
    /// If the data cannot be read.
    pub fn expected(
        setup: Setup,
        hyperparameters: &Hyperparameters,
        data: &DataFiles,
    ) -> anyhow::Result<ResultSettings> {
        let digest = |path: &Path| digest(path).context("run `pathlight-lab reproduce --only data` first");
        Ok(ResultSettings::of_today(setup, hyperparameters, digest(&data.solutions)?, digest(&data.labels)?))
    }

    fn of_today(setup: Setup, hyperparameters: &Hyperparameters, solutions: String, labels: String) -> ResultSettings {
        let &Hyperparameters { seed, epochs, dqn_epochs, .. } = hyperparameters;
        let Recipes { success, dynamics, dqn } = Recipes::of(setup);
        let shared = SharedSettings {
            hyperparameters: hyperparameters.clone(),
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            solutions,
            labels,
        };
        let nets = NetsSettings {
            success: NetSettings { seed, epochs: epochs.into(), recipe: success },
            dynamics: NetSettings { seed, epochs: epochs.into(), recipe: dynamics },
            dqn: NetSettings { seed, epochs: dqn_epochs.into(), recipe: dqn },
        };
        ResultSettings { setup, shared, nets }
    }

    /// Names the settings that differ; empty if none do. Those of the nets are compared only within a setup.
    pub fn differences(&self, other: &ResultSettings) -> String {
        let shared = differences(&self.shared, &other.shared);
        let nets = if self.setup == other.setup { differences(&self.nets, &other.nets) } else { String::new() };
        [shared, nets].into_iter().filter(|named| !named.is_empty()).collect::<Vec<_>>().join(", ")
    }
}

impl FoldResult {
    /// Reads the result of a fold; `None` if there is no file.
    fn load(path: &Path, fold: FoldId) -> anyhow::Result<Option<FoldResult>> {
        let name = path.display();
        let bytes = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            read => read.with_context(|| format!("cannot read {name}"))?,
        };
        let text = utf8(&bytes).with_context(|| format!("cannot read {name}"))?;
        let result: FoldResult = serde_json::from_str(text)
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
    fn settings(&self) -> anyhow::Result<ResultSettings> {
        let success = self.success.card.success.as_ref().context("the card of `success` has no success net")?;
        let dynamics = self.dynamics.card.dynamics.as_ref().context("the card of `dynamics` has no dynamics net")?;
        ensure!(
            dynamics.from.is_none()
                && !(dynamics.without_paths || dynamics.without_dev)
                && self.success.data == self.dynamics.data
                && self.dqn.data == self.dynamics.data,
            "success net, dynamics net and DQN were not trained on the same labels, from fresh weights"
        );
        let shared = SharedSettings {
            hyperparameters: self.hyperparameters.clone(),
            simulator: self.report.simulator,
            agents_version: self.report.agents_version,
            solutions: self.solutions.clone(),
            labels: self.dynamics.data.clone(),
        };
        let dqn = &self.dqn.card;
        let nets = NetsSettings {
            success: NetSettings { seed: success.seed, epochs: success.epochs, recipe: recipe_of(success) },
            dynamics: NetSettings { seed: dynamics.seed, epochs: dynamics.epochs, recipe: recipe_of(dynamics) },
            dqn: NetSettings { seed: dqn.seed, epochs: dqn.epochs, recipe: recipe_of(dqn) },
        };
        Ok(ResultSettings { setup: self.report.setup, shared, nets })
    }
}

/// A result in a folder.
pub struct Existing {
    pub path: PathBuf,
    pub result: FoldResult,
    /// The settings it was made with.
    pub settings: ResultSettings,
}

/// Reads all results in a folder, within before cross, folds ascending.
///
/// # Errors
/// If a file is damaged.
pub fn existing(folder: &Path) -> anyhow::Result<Vec<Existing>> {
    let mut all = Vec::new();
    for fold in FoldId::all() {
        let path = folder.join(format!("{fold}.json"));
        if let Some(result) = FoldResult::load(&path, fold)? {
            let settings = result.settings().with_context(|| {
                format!("{} is not as `pathlight-lab reproduce` makes it: remove it", path.display())
            })?;
            all.push(Existing { path, result, settings });
        }
    }
    Ok(all)
}

/// Reads all results in a folder, at least one, within before cross, folds ascending.
///
/// # Errors
/// If there is none, a file is damaged, or results have different settings.
pub fn read(folder: &Path) -> anyhow::Result<Vec<FoldResult>> {
    let all = existing(folder)?;
    ensure!(!all.is_empty(), "{} holds no results: run `pathlight-lab reproduce` first", folder.display());
    for (index, Existing { path, settings, .. }) in all.iter().enumerate() {
        for before in &all[..index] {
            let other = settings.differences(&before.settings);
            ensure!(
                other.is_empty(),
                "{} was made with other settings than the results before it ({other}): keep such results in different \
                 folders (--results)",
                path.display()
            );
        }
    }
    Ok(all.into_iter().map(|existing| existing.result).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The labels are not in the repository.
    #[test]
    fn results_of_the_repository_were_made_with_the_settings_of_today() {
        let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let all = existing(&repository.join("results")).expect("results");
        assert_eq!(all.len(), 20);
        let solutions = digest(&repository.join("assets/solutions.jsonl")).expect("solutions");
        for Existing { path, result, settings } in &all {
            let (setup, labels) = (result.report.setup, all[0].settings.shared.labels.clone());
            let mut today = ResultSettings::of_today(setup, &Hyperparameters::default(), solutions.clone(), labels);
            // They are of one version of the simulator, whichever.
            today.shared.simulator = all[0].settings.shared.simulator;
            assert_eq!(settings.differences(&today), "", "{}", path.display());
            let written = serde_json::to_vec(result).expect("plain data");
            let written: FoldResult = serde_json::from_slice(&written).expect("a result");
            assert_eq!(written.settings().expect("settings").differences(&today), "", "{}", path.display());
        }
    }
}
