//! Trains and measures every fold of both setups, and reports on the results.
//!
//! Three parts: the data that all folds share; a result per setup and fold, as a JSON file each; a report on the
//! existing results. Each part continues where it was interrupted. Results do not depend on each other, so they can be
//! made in parallel, on several machines.

use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::benchmark::folds::FoldId;

use crate::data::collect::{self, SOLUTIONS};
use crate::data::label::{self, LABELS};
use crate::files::quoted::quoted;
use crate::progress::Progress;
use fold_result::{DataFiles, Hyperparameters, ResultSettings};

pub mod compared;
mod costs;
pub mod fold_result;
mod fold_run;
pub mod other_data;
mod recipes;
pub mod report;
mod training_report;

/// The folder of the results in the repository.
pub const RESULTS: &str = "results";

/// What to reproduce, and where it is kept.
pub struct Settings {
    /// Folder of the results and of the report.
    pub results: PathBuf,
    /// Data that are made until they are complete, and trained on.
    pub data: DataFiles,
    /// Folder of the training runs, each in its own subfolder SETUP-FOLD.
    pub train_dir: PathBuf,
    pub hyperparameters: Hyperparameters,
}

impl Default for Settings {
    fn default() -> Settings {
        let data = DataFiles { solutions: SOLUTIONS.into(), labels: LABELS.into() };
        let hyperparameters = Hyperparameters::default();
        Settings { results: RESULTS.into(), data, train_dir: "target/reproduce".into(), hyperparameters }
    }
}

impl Settings {
    /// Collects solutions and labels balls, or continues with it.
    ///
    /// # Errors
    /// If a file cannot be continued or written.
    pub fn make_data(&self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let DataFiles { solutions, labels } = &self.data;
        progress.say(&format!("$ pathlight-lab data collect --out {}", quoted(solutions)));
        let search = collect::Settings { out: solutions.clone(), ..collect::Settings::default() };
        let found = search.search(progress)?;
        progress.say(found.trim_end());
        let rounds = self.hyperparameters.label_rounds;
        progress.say(&format!(
            "$ pathlight-lab data label --solutions {} --out {} --rounds {rounds}",
            quoted(solutions),
            quoted(labels)
        ));
        let settings = label::Settings {
            out: labels.clone(),
            solutions: solutions.clone(),
            rounds: rounds.into(),
            ..label::Settings::default()
        };
        settings.label(progress)
    }

    /// Makes the result of a fold, unless its file exists.
    ///
    /// # Errors
    /// If the file, or another result in the folder, was made with other settings, or the result cannot be made.
    pub fn make_result(&self, fold: FoldId, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let path = self.results.join(format!("{fold}.json"));
        let name = path.display();
        let results = fold_result::existing(&self.results)?;
        if !results.is_empty() {
            let expected = ResultSettings::expected(fold.setup, &self.hyperparameters, &self.data)?;
            for existing in &results {
                let other = existing.settings.differences(&expected);
                ensure!(
                    other.is_empty(),
                    "{} was made with other settings than asked for ({other}), and one report cannot have both: choose \
                     other folders with --results and --train-dir, or remove it",
                    existing.path.display()
                );
            }
        }
        if results.iter().any(|existing| existing.path == path) {
            progress.say(&format!("{name} exists"));
            return Ok(());
        }
        let folder = self.train_dir.join(fold.to_string());
        let result = fold_run::run(fold, &self.hyperparameters, &self.data, &folder, progress);
        result.with_context(|| format!("cannot make {name}"))?.save(&path)?;
        progress.say(&format!("wrote {name}"));
        Ok(())
    }

    /// Writes README.md and costs.md of the existing results; returns the first.
    ///
    /// # Errors
    /// If results cannot be used, or the folder cannot be written.
    pub fn report(&self) -> anyhow::Result<String> {
        let results = compared::main_results(&self.results)?;
        let text = report::write(&results, &self.results)?;
        costs::write(&results, &self.results)?;
        Ok(text)
    }
}
