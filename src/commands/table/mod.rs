//! `pathlight table`: the paper's table over folds and setups, every row by the other commands, and a report.
//!
//! Three parts, by default one after the other: the data that all rows share (`collect`, `label`); the rows, one
//! JSON file for each setup and fold (`train`, `judge`, `evaluate`); the report (Markdown and a picture) of the
//! rows that there are. Each goes on where it was cut off. A row writes nothing that another row reads, so rows
//! can be made by as many processes as there are machines.

use std::path::PathBuf;

use anyhow::{Context, ensure};
use clap::ValueEnum;
use pathlight::benchmark::folds::{FOLDS, Setup};

use super::fold_args::{FoldArgs, setup};
use super::run_words;
use row::{Data, Recipe, Row};

mod picture;
mod report;
mod row;

/// Make or go on with the table of results: data, rows, report
#[derive(clap::Args)]
pub struct Args {
    /// One part alone
    #[arg(long, value_enum)]
    only: Option<Part>,

    /// Rows of this setup alone
    #[arg(long, value_parser = setup())]
    setup: Option<Setup>,

    /// Rows of this fold alone; can be given several times [default: all ten]
    #[arg(long = "fold", value_name = "FOLD", value_parser = clap::value_parser!(u8).range(0..i64::from(FOLDS)))]
    folds: Vec<u8>,

    /// Folder of the rows and of the report
    #[arg(long, default_value = "results")]
    results: PathBuf,

    /// Solutions of all tasks: collected until complete, and trained on
    #[arg(long, default_value = "assets/solutions.jsonl")]
    solutions: PathBuf,

    /// Balls with their outcome: labelled until complete, and judged by
    #[arg(long, default_value = "target/labels.jsonl")]
    labels: PathBuf,

    /// Folder of the training runs, each in a folder SETUP-FOLD of its own
    #[arg(long, default_value = "target/train")]
    runs: PathBuf,

    #[command(flatten)]
    recipe: Recipe,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Part {
    /// Solutions and labelled balls, which all rows share
    Data,
    /// Train, judge and evaluate, a JSON file for each setup and fold
    Rows,
    /// README.md and a picture, from the rows that there are
    Report,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let wanted = |part| self.only.is_none_or(|only| only == part);
        let data = Data { solutions: self.solutions.clone(), labels: self.labels.clone() };
        if wanted(Part::Data) {
            let (solutions, labels) = (data.solutions.display().to_string(), data.labels.display().to_string());
            let rounds = self.recipe.label_rounds.to_string();
            run_words(&["collect", "--out", &solutions].map(String::from))?;
            let label = ["label", "--solutions", &solutions, "--out", &labels, "--rounds", &rounds];
            run_words(&label.map(String::from))?;
        }
        if wanted(Part::Rows) {
            let folds = if self.folds.is_empty() { (0..FOLDS).collect() } else { self.folds.clone() };
            for fold in folds {
                for setup in [Setup::Within, Setup::Cross] {
                    if self.setup.is_none_or(|one| one == setup) {
                        self.row(&FoldArgs { setup, fold }, &data)?;
                    }
                }
            }
        }
        if wanted(Part::Report) {
            report::write(&row::read(&self.results)?, &self.solutions, &self.results)?;
        }
        Ok(())
    }

    /// Makes a row, unless it is there.
    fn row(&self, which: &FoldArgs, data: &Data) -> anyhow::Result<()> {
        let path = self.results.join(format!("{which}.json"));
        let name = path.display();
        if let Some(row) = Row::load(&path)? {
            ensure!(
                row.is_of(&self.recipe, data)?,
                "{name} was made with other settings, data or simulator: name other folders with --results and \
                 --runs, or remove it"
            );
            eprintln!("{name} is there");
            return Ok(());
        }
        let folder = self.runs.join(which.to_string());
        let row = Row::make(which, &self.recipe, data, &folder);
        row.with_context(|| format!("cannot make {name} (here --out is called --runs)"))?.save(&path)
    }
}
