//! `pathlight reproduce`: reproduces the paper's table over setups and folds, with the other commands, and reports on
//! it.
//!
//! Three parts, by default one after the other: the data that all folds share (`collect`, `label`); a result per setup
//! and fold, as a JSON file each (`train`, `train-judge`, `train-dynamics`, `train-dqn`, `evaluate`); a report on the
//! existing results. Each part continues where it was interrupted. Results do not depend on each other, so they can be
//! made in parallel, on several machines.

use std::io::{self, Write as _};
use std::path::PathBuf;

use anyhow::{Context, ensure};
use clap::ValueEnum;
use pathlight::benchmark::folds::{FOLDS, Setup};

use super::fold_args::{FoldArgs, setup};
use super::progress::say;
use super::{collect, defaults, label};
use fold_result::{DataFiles, FoldResult, Hyperparameters, ResultSettings};

mod costs;
pub mod fold_result;
mod fold_run;
pub mod report;
mod training_report;

/// Reproduce the paper's table, or continue with it: data, folds, report
#[derive(clap::Args)]
pub struct Args {
    /// Do only this part
    #[arg(long, value_enum)]
    only: Option<Part>,

    /// Only folds of this setup
    #[arg(long, value_parser = setup())]
    setup: Option<Setup>,

    /// Only this fold; can be repeated [default: all ten]
    #[arg(long = "fold", value_name = "FOLD", value_parser = clap::value_parser!(u8).range(0..i64::from(FOLDS)))]
    folds: Vec<u8>,

    /// Folder of the results and of the report
    #[arg(long, value_name = "DIR", default_value = "results")]
    results: PathBuf,

    /// Solutions of all tasks: collected until complete, and trained on
    #[arg(long, default_value = "assets/solutions.jsonl")]
    solutions: PathBuf,

    /// Balls with their outcome: labelled until complete, and trained on by the judge, the dynamics net and DQN
    #[arg(long, default_value = "target/labels.jsonl")]
    labels: PathBuf,

    /// Balls in variants of the scenes: labelled until complete, and trained on by the dynamics net
    #[arg(long, default_value = "target/variants.jsonl")]
    variants: PathBuf,

    /// Folder of the training runs, each in its own subfolder SETUP-FOLD
    #[arg(long, value_name = "DIR", default_value = "target/train")]
    train_dir: PathBuf,

    #[command(flatten)]
    hyperparameters: Hyperparameters,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Part {
    /// Solutions and labelled balls, which all folds share
    Data,
    /// Training and evaluation: a JSON file per setup and fold
    Folds,
    /// README.md and costs.md of the existing results
    Report,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let asked = |part| self.only.is_none_or(|only| only == part);
        let data = DataFiles {
            solutions: self.solutions.clone(),
            labels: self.labels.clone(),
            variants: self.variants.clone(),
        };
        if asked(Part::Data) {
            self.make_data()?;
        }
        if asked(Part::Folds) {
            for fold in self.chosen_folds() {
                self.make_result(fold, &data)?;
            }
        }
        if asked(Part::Report) {
            let results = fold_result::read(&self.results)?;
            let text = report::write(&results, &self.solutions, &self.results)?;
            costs::write(&results, &self.solutions, &self.results)?;
            // All is written before anything is printed, so that a closed pipe does not stop halfway.
            io::stdout().write_all(text.as_bytes())?;
        }
        Ok(())
    }

    /// The folds to make results of, both setups of a fold one after the other.
    fn chosen_folds(&self) -> Vec<FoldArgs> {
        let folds = if self.folds.is_empty() { (0..FOLDS).collect() } else { self.folds.clone() };
        let setups =
            [Setup::Within, Setup::Cross].into_iter().filter(|&one| self.setup.is_none_or(|setup| setup == one));
        folds.into_iter().flat_map(|fold| setups.clone().map(move |setup| FoldArgs { setup, fold })).collect()
    }

    /// Collects solutions and labels balls.
    fn make_data(&self) -> anyhow::Result<()> {
        let solutions = self.solutions.display();
        if !collect::is_of_earlier_search(&self.solutions)? {
            say(&format!("$ pathlight collect --out {solutions}"));
            say(collect::Args { out: self.solutions.clone(), ..defaults() }.search()?.trim_end());
        }
        let &Hyperparameters { label_rounds, variant_rounds, .. } = &self.hyperparameters;
        for (out, rounds, variants) in [(&self.labels, label_rounds, false), (&self.variants, variant_rounds, true)] {
            let option = if variants { " --variants" } else { "" };
            say(&format!(
                "$ pathlight label --solutions {solutions} --out {} --rounds {rounds}{option}",
                out.display()
            ));
            let (out, solutions) = (out.clone(), self.solutions.clone());
            label::Args { out, solutions, rounds: rounds.into(), variants, ..defaults() }.run()?;
        }
        Ok(())
    }

    /// Makes the result of a fold, unless its file exists.
    fn make_result(&self, fold: FoldArgs, data: &DataFiles) -> anyhow::Result<()> {
        let path = self.results.join(format!("{fold}.json"));
        let name = path.display();
        if let Some(result) = FoldResult::load(&path, fold)? {
            let other = result.settings().differences(&ResultSettings::expected(&self.hyperparameters, data)?);
            ensure!(
                other.is_empty(),
                "{name} was made with other settings ({other}): choose other folders with --results and --train-dir, \
                 or remove it"
            );
            say(&format!("{name} exists"));
            return Ok(());
        }
        let folder = self.train_dir.join(fold.to_string());
        let result = fold_run::run(fold, &self.hyperparameters, data, &folder);
        result.with_context(|| format!("cannot make {name}"))?.save(&path)
    }
}
