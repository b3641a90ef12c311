//! The result of one setup and fold: its JSON file.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::DqnCard;
use serde::{Deserialize, Serialize};

use super::result_settings::{Hyperparameters, Recipes, ResultSettings};
use crate::files::replace_file::replace_file;
use crate::measure::evaluate::Report;
use crate::training::settings::recipe_of;
use crate::training::training_run::Checkpoint;

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
    /// What follows it; older rows have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hard_negatives: Option<HardNegatives>,
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

/// The further training of the dynamics net, on hard negatives too.
#[derive(Serialize, Deserialize)]
pub struct HardNegatives {
    /// Wall-clock time of labelling them, s.
    pub labelling_seconds: f64,
    pub training: Checkpoint,
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
        let found = FoldId { setup: result.report.setup, fold: result.report.fold };
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
        let further = self.hard_negatives.as_ref().and_then(|further| further.training.card.dynamics.as_ref());
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
                hard_negatives: further.map(recipe_of),
                dqn: recipe_of(&self.dqn.card),
            },
        }
    }
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
    use pathlight::{agents, simulator};

    use super::*;

    /// A row of the repository; its settings are today's defaults but for the data, which are not in it, and the hard
    /// negatives, which it has not seen.
    #[test]
    fn rows_of_the_repository_were_made_with_the_settings_of_today() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results");
        let results = read(&folder).expect("the rows agree");
        assert_eq!(results.len(), 20);
        let row = results[3].settings().of_today();
        let hyperparameters =
            Hyperparameters { hard_negative_rounds: 0, hard_negative_epochs: 0, ..Hyperparameters::default() };
        let today = ResultSettings {
            recipes: Recipes::of(&hyperparameters),
            hyperparameters,
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            solutions: row.solutions.clone(),
            labels: row.labels.clone(),
            labels_and_variants: row.labels_and_variants.clone(),
        };
        assert_eq!(row.differences(&today), "");
        let written: FoldResult =
            serde_json::from_slice(&serde_json::to_vec(&results[3]).expect("plain data")).expect("a row");
        assert_eq!(written.settings().of_today().differences(&today), "", "a row that is written now is read alike");
    }

    #[test]
    fn a_row_with_the_old_names_of_the_success_net_is_read_alike() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results/cross-3.json");
        let text = fs::read_to_string(file).expect("a row");
        let old = ["\"", "_epochs\"", "_epochs_cross\""]
            .into_iter()
            .fold(text.clone(), |text, end| text.replace(&format!("\"success{end}"), &format!("\"judge{end}")));
        assert!(old.contains("\"judge_epochs_cross\":60") && !old.contains("\"success"));
        let [old, row] = [old, text].map(|text| serde_json::from_str::<FoldResult>(&text).expect("a row"));
        assert_eq!(old.settings().differences(&row.settings()), "");
        let score = |row: &FoldResult| row.report.score(AgentName::Success);
        assert!(score(&row).is_some());
        assert_eq!(score(&old), score(&row));
    }
}
