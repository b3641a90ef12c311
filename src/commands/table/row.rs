//! A row of the table: one setup and fold, trained, judged and evaluated; and its JSON file.

use std::fmt::Display;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, ensure};
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use crate::commands::evaluate::{Agent, Report};
use crate::commands::fold_args::FoldArgs;
use crate::commands::training_run::{State, state};
use crate::commands::{digest, label, run_words};

/// The settings of a table. The defaults are those of the results in the repository.
#[derive(Clone, Debug, PartialEq, clap::Args, Serialize, Deserialize)]
pub struct Recipe {
    /// Seed of training and evaluation
    #[arg(long, default_value_t = 0)]
    pub seed: u64,

    /// Rounds of labelling; in each, every task tries 64 balls
    #[arg(long, default_value_t = 15)]
    pub label_rounds: u16,

    /// Passes over the samples, of the four nets
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..))]
    pub epochs: u16,

    /// Passes over the scenes, of a judge within templates
    #[arg(long, default_value_t = 150, value_parser = clap::value_parser!(u16).range(1..))]
    pub judge_epochs: u16,

    /// Passes over the scenes, of a judge across templates
    #[arg(long, default_value_t = 60, value_parser = clap::value_parser!(u16).range(1..))]
    pub judge_epochs_cross: u16,

    /// Tasks of each template to play at most
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..))]
    pub limit: u16,
}

/// The files that a row is made from, which it only reads.
pub struct Data {
    pub solutions: PathBuf,
    pub labels: PathBuf,
}

/// All that is known of a row.
#[derive(Serialize, Deserialize)]
pub struct Row {
    pub recipe: Recipe,
    /// How the training of the four nets went.
    pub nets: State,
    /// How the training of the judge went.
    pub judge: State,
    /// Size of the weights of all five nets, bytes.
    pub weights: u64,
    /// Wall-clock time of the evaluation of all agents, s.
    pub evaluation_seconds: f64,
    pub report: Report,
}

impl Row {
    /// Trains, judges and evaluates, in a folder of the row's own, by the commands that a person would type. Goes
    /// on where it was cut off.
    ///
    /// # Errors
    /// If the labelled balls are not those of the recipe, and those of the commands.
    pub fn make(which: &FoldArgs, recipe: &Recipe, data: &Data, folder: &Path) -> anyhow::Result<Row> {
        let rounds = label::read_labels(&data.labels)?.rounds();
        ensure!(
            rounds == Some(recipe.label_rounds.into()),
            "{} does not hold the balls of {} rounds: run `pathlight table --only data`, or say --label-rounds",
            data.labels.display(),
            recipe.label_rounds
        );
        let judge_epochs = match which.setup {
            Setup::Within => recipe.judge_epochs,
            Setup::Cross => recipe.judge_epochs_cross,
        };
        let of_judge = folder.join("judge");
        let (nets, judged) = (folder.join("weights.safetensors"), of_judge.join("weights.safetensors"));
        let evaluation = folder.join("evaluation.json");
        let command = |name: &str, options: &[(&str, &dyn Display)]| {
            let common: [(&str, &dyn Display); 3] =
                [("setup", &which.setup), ("fold", &which.fold), ("seed", &recipe.seed)];
            let options = common.iter().chain(options);
            let words = options.flat_map(|(option, value)| [format!("--{option}"), value.to_string()]);
            run_words(&[name.to_string()].into_iter().chain(words).collect::<Vec<_>>())
        };
        let (solutions, labels) = (data.solutions.display(), data.labels.display());
        command("train", &[("solutions", &solutions), ("epochs", &recipe.epochs), ("out", &folder.display())])?;
        let judge: [(&str, &dyn Display); 4] = [
            ("weights", &nets.display()),
            ("labels", &labels),
            ("epochs", &judge_epochs),
            ("out", &of_judge.display()),
        ];
        command("train-judge", &judge)?;
        let started = Instant::now();
        let (weights, json) = (judged.display(), evaluation.display());
        command("evaluate", &[("weights", &weights), ("limit", &recipe.limit), ("json", &json)])?;
        let trained = |folder: &Path| state(folder)?.with_context(|| format!("no run in {}", folder.display()));
        Ok(Row {
            recipe: recipe.clone(),
            nets: trained(folder)?,
            judge: trained(&of_judge)?,
            weights: fs::metadata(&judged)?.len(),
            evaluation_seconds: started.elapsed().as_secs_f64(),
            report: serde_json::from_slice(&fs::read(&evaluation)?)?,
        })
    }

    /// The row of a file; none if there is no file.
    ///
    /// # Errors
    /// If the file is no row.
    pub fn load(path: &Path) -> anyhow::Result<Option<Row>> {
        let bytes = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            read => read.with_context(|| format!("cannot read {}", path.display()))?,
        };
        let row = serde_json::from_slice(&bytes);
        row.map(Some).with_context(|| format!("{} is no row of `pathlight table`: remove it", path.display()))
    }

    /// Writes the file, all of it or nothing.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn save(&self, path: &Path) -> anyhow::Result<()> {
        let part = path.with_extension("part");
        let write = || {
            path.parent().map_or(Ok(()), fs::create_dir_all)?;
            fs::write(&part, serde_json::to_vec(self)?)?;
            fs::rename(&part, path)
        };
        write().with_context(|| format!("cannot write {}", path.display()))?;
        eprintln!("wrote {}", path.display());
        Ok(())
    }

    /// Is it made with this recipe, from these data, in this simulator?
    ///
    /// # Errors
    /// If the data cannot be read.
    pub fn is_of(&self, recipe: &Recipe, data: &Data) -> anyhow::Result<bool> {
        Ok(self.recipe == *recipe
            && self.report.simulator == simulator::VERSION
            && self.nets.data == digest(&data.solutions)?
            && self.judge.data == digest(&data.labels)?)
    }

    /// May both stand in one table?
    pub fn goes_with(&self, other: &Row) -> bool {
        self.recipe == other.recipe
            && self.report.simulator == other.report.simulator
            && [&self.nets.data, &self.judge.data] == [&other.nets.data, &other.judge.data]
    }

    /// The attempts that first solved its tasks, those of a template or all; none for an agent that did not play.
    pub fn first_solved(&self, agent: Agent, template: Option<usize>) -> Vec<Option<usize>> {
        let score = self.report.agents.iter().find(|score| score.agent == agent);
        let all = score.into_iter().flat_map(|score| &score.first_solved);
        all.filter(|(task, _)| template.is_none_or(|one| task.template == one)).map(|&(_, first)| first).collect()
    }

    /// Auccess and the shares solved at the first attempt, within 10 and within 100; all in percent.
    pub fn score(&self, agent: Agent) -> [f64; 4] {
        let firsts = self.first_solved(agent, None);
        let [one, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved_within(&firsts, attempts));
        [auccess(&firsts), one, ten, hundred]
    }
}

/// All rows in a folder, within before cross, folds ascending.
///
/// # Errors
/// If there is none, a row's file is damaged, or rows were made in different ways.
pub fn read(folder: &Path) -> anyhow::Result<Vec<Row>> {
    let mut rows: Vec<Row> = Vec::new();
    for setup in [Setup::Within, Setup::Cross] {
        for fold in 0..FOLDS {
            let path = folder.join(format!("{}.json", FoldArgs { setup, fold }));
            let Some(row) = Row::load(&path)? else { continue };
            ensure!(
                rows.first().is_none_or(|first| first.goes_with(&row)),
                "{} was made with other settings, data or simulator than the rows before it: keep such rows in \
                 folders of their own (--results)",
                path.display()
            );
            rows.push(row);
        }
    }
    ensure!(!rows.is_empty(), "{} holds no rows: run `pathlight table` first", folder.display());
    Ok(rows)
}
