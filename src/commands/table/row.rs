//! A row of the table: one setup and fold, trained, judged and evaluated; and its JSON file.

use std::fs;
use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::auccess::{auccess, share_within};
use pathlight::folds::Setup;
use serde::{Deserialize, Serialize};

use crate::commands::evaluate::{Agent, Report};
use crate::commands::which::Which;
use crate::commands::{run, run_words, sha256};

/// The settings of a table. The defaults are the ones that the results beside the README were made with.
#[derive(Clone, Debug, PartialEq, clap::Args, Serialize, Deserialize)]
pub struct Recipe {
    /// Seed of all that is drawn
    #[arg(long, default_value_t = 0)]
    pub seed: u64,

    /// Rounds of labelling; in each, every task tries 64 balls
    #[arg(long, default_value_t = 15)]
    pub label_rounds: usize,

    /// Passes over the samples, of the four nets
    #[arg(long, default_value_t = 10)]
    pub epochs: usize,

    /// Passes over the scenes, of a judge within templates
    #[arg(long, default_value_t = 150)]
    pub judge_epochs: usize,

    /// Passes over the scenes, of a judge across templates, where a longer training learns the templates by heart
    #[arg(long, default_value_t = 60)]
    pub judge_epochs_cross: usize,

    /// Tasks of each template to play at most
    #[arg(long, value_name = "N", default_value_t = 100)]
    pub limit: usize,
}

/// All that is known of a row.
#[derive(Serialize, Deserialize)]
pub struct Row {
    pub recipe: Recipe,
    /// SHA-256 of the file of solutions, and of the file of labelled balls.
    pub data: [String; 2],
    pub nets: Training,
    pub judge: Training,
    /// Wall-clock time of the evaluation of all agents, s.
    pub evaluation_seconds: f64,
    pub report: Report,
}

/// How a training run went.
#[derive(Serialize, Deserialize)]
pub struct Training {
    /// Wall-clock time, s.
    pub seconds: f64,
    /// Names of the losses.
    pub losses: Vec<String>,
    /// Mean losses of each epoch.
    pub by_epoch: Vec<Vec<f64>>,
}

impl Row {
    /// Trains, judges and evaluates, in a folder of the row's own, by the commands that a person would type. Goes
    /// on where it was cut off.
    ///
    /// # Errors
    /// Those of the commands.
    pub fn make(which: &Which, recipe: &Recipe, solutions: &Path, labels: &Path, folder: &Path) -> anyhow::Result<Row> {
        let judge_epochs = match which.setup {
            Setup::Within => recipe.judge_epochs,
            Setup::Cross => recipe.judge_epochs_cross,
        };
        let judge = folder.join("judge");
        let (nets, judged) = (folder.join("weights.safetensors"), judge.join("weights.safetensors"));
        let evaluation = folder.join("evaluation.json");
        let command = |name: &str, more: &[(&str, &dyn std::fmt::Display)]| {
            let mut words = vec![name.to_string()];
            let common: [(&str, &dyn std::fmt::Display); 3] =
                [("setup", &which.setup), ("fold", &which.fold), ("seed", &recipe.seed)];
            for (option, value) in common.iter().chain(more) {
                words.extend([format!("--{option}"), value.to_string()]);
            }
            run_words(&words)
        };
        command(
            "train",
            &[("solutions", &solutions.display()), ("epochs", &recipe.epochs), ("out", &folder.display())],
        )?;
        command(
            "judge",
            &[
                ("weights", &nets.display()),
                ("labels", &labels.display()),
                ("epochs", &judge_epochs),
                ("out", &judge.display()),
            ],
        )?;
        let started = std::time::Instant::now();
        command(
            "evaluate",
            &[("weights", &judged.display()), ("limit", &recipe.limit), ("json", &evaluation.display())],
        )?;
        Ok(Row {
            recipe: recipe.clone(),
            data: [digest(solutions)?, digest(labels)?],
            nets: Training::of(folder)?,
            judge: Training::of(&judge)?,
            evaluation_seconds: started.elapsed().as_secs_f64(),
            report: serde_json::from_slice(&fs::read(&evaluation)?)?,
        })
    }

    /// The row of a file; none if there is no file.
    ///
    /// # Errors
    /// If the file is no row.
    pub fn load(path: &Path) -> anyhow::Result<Option<Row>> {
        let Ok(bytes) = fs::read(path) else { return Ok(None) };
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

    /// The attempts that first solved its tasks, those of a template or all; none for an agent that did not play.
    pub fn first_solved(&self, agent: Agent, template: Option<usize>) -> Vec<Option<usize>> {
        let score = self.report.agents.iter().find(|score| score.agent == agent);
        let all = score.into_iter().flat_map(|score| &score.first_solved);
        all.filter(|(task, _)| template.is_none_or(|one| task.template == one)).map(|&(_, first)| first).collect()
    }

    /// Auccess and the shares solved at the first attempt, within 10 and within 100; all in percent.
    pub fn score(&self, agent: Agent) -> [f64; 4] {
        let firsts = self.first_solved(agent, None);
        let [one, ten, hundred] = [1, 10, 100].map(|attempts| 100.0 * share_within(&firsts, attempts));
        [auccess(&firsts), one, ten, hundred]
    }
}

impl Training {
    /// What a run in a folder says of itself.
    fn of(folder: &Path) -> anyhow::Result<Training> {
        let state = run::state(folder)?.with_context(|| format!("no run in {}: train again", folder.display()))?;
        let text = run::losses(folder)?;
        let mut lines = text.lines().map(|line| line.split(','));
        let losses: Vec<String> = lines.next().into_iter().flatten().skip(2).map(String::from).collect();
        let mut sums: Vec<(usize, Vec<f64>)> = Vec::new();
        for mut line in lines {
            let epoch: usize = line.next().unwrap_or_default().parse()?;
            let numbers = line.skip(1).map(str::parse).collect::<Result<Vec<f64>, _>>()?;
            ensure!(numbers.len() == losses.len(), "the losses in {} are damaged: train again", folder.display());
            sums.resize(sums.len().max(epoch + 1), (0, vec![0.0; losses.len()]));
            let (count, sum) = &mut sums[epoch];
            *count += 1;
            sum.iter_mut().zip(numbers).for_each(|(sum, number)| *sum += number);
        }
        let mean = |(count, sum): (usize, Vec<f64>)| sum.iter().map(|sum| sum / count.max(1) as f64).collect();
        Ok(Training { seconds: state.seconds, losses, by_epoch: sums.into_iter().map(mean).collect() })
    }
}

/// All rows in a folder, within before cross, folds ascending.
///
/// # Errors
/// If a row's file is damaged.
pub fn read(folder: &Path) -> anyhow::Result<Vec<Row>> {
    let mut rows = Vec::new();
    for setup in [Setup::Within, Setup::Cross] {
        for fold in 0..pathlight::folds::FOLDS {
            rows.extend(Row::load(&folder.join(format!("{}.json", Which { setup, fold })))?);
        }
    }
    Ok(rows)
}

fn digest(path: &Path) -> anyhow::Result<String> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(sha256(&bytes))
}
