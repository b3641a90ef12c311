//! The result of one setup and fold: its JSON file, the settings that it was made with, and whether results are
//! comparable.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::agents;
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::nets::DqnCard;
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use crate::commands::agent_name::AgentName;
use crate::commands::differences::differences;
use crate::commands::evaluate::Report;
use crate::commands::fold_args::FoldArgs;
use crate::commands::progress::say;
use crate::commands::replace_file::replace_file;
use crate::commands::training_run::Checkpoint;
use crate::commands::{defaults, digest, train, train_dqn, train_dynamics, train_judge};

/// Scenes in a batch of DQN: fewer than the other nets take, so that a short training has more steps.
pub const DQN_BATCH: u16 = 16;

/// Settings that can be chosen for a table. The defaults are those of the results in the repository.
#[derive(Clone, Debug, PartialEq, clap::Args, Serialize, Deserialize)]
pub struct Hyperparameters {
    /// Seed of training and evaluation
    #[arg(long, default_value_t = 0)]
    pub seed: u64,

    /// Rounds of labelling; every task tries 64 balls per round
    #[arg(long, value_name = "ROUNDS", default_value_t = 15)]
    pub label_rounds: u16,

    /// Rounds of labelling variants of the scenes, another variant of each task and 64 balls per round
    #[arg(long, value_name = "ROUNDS", default_value_t = 4)]
    pub variant_rounds: u16,

    /// Epochs of the four nets
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..))]
    pub epochs: u16,

    /// Epochs of the judge in the setup within
    #[arg(long, value_name = "EPOCHS", default_value_t = 150, value_parser = clap::value_parser!(u16).range(1..))]
    pub judge_epochs: u16,

    /// Epochs of the judge in the setup cross
    #[arg(long, value_name = "EPOCHS", default_value_t = 60, value_parser = clap::value_parser!(u16).range(1..))]
    pub judge_epochs_cross: u16,

    /// Epochs of the dynamics net, over scenes and variants
    #[arg(long, value_name = "EPOCHS", default_value_t = 12, value_parser = clap::value_parser!(u16).range(1..))]
    pub dynamics_epochs: u16,

    /// Epochs of DQN
    #[arg(long, value_name = "EPOCHS", default_value_t = 15, value_parser = clap::value_parser!(u16).range(1..))]
    pub dqn_epochs: u16,

    /// Use at most the first N test tasks of each template
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..))]
    pub limit: u16,
}

/// The input files of a result; read only.
pub struct DataFiles {
    pub solutions: PathBuf,
    pub labels: PathBuf,
    pub variants: PathBuf,
}

/// The result of a setup and fold.
#[derive(Serialize, Deserialize)]
pub struct FoldResult {
    pub hyperparameters: Hyperparameters,
    /// The training of the four nets.
    pub nets: Checkpoint,
    /// The training of the judge.
    pub judge: Checkpoint,
    /// The training of the dynamics net, which starts from the judge.
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
    batch: u16,
    learning_rate: f64,
    decay_epochs: usize,
    mirror: bool,
    without_dev: bool,
    judge_batch: Option<u16>,
    judge_learning_rate: Option<f64>,
    balls_per_scene: Option<u16>,
    dynamics_batch: Option<u16>,
    dynamics_learning_rate: Option<f64>,
    dynamics_balls_per_scene: Option<u16>,
    imagined_per_scene: Option<u16>,
    dqn_batch: u16,
    dqn_learning_rate: f64,
    dqn_balls_per_scene: u16,
}

impl ResultSettings {
    /// The settings of a result made now.
    ///
    /// # Errors
    /// If the data cannot be read.
    pub fn expected(hyperparameters: &Hyperparameters, data: &DataFiles) -> anyhow::Result<ResultSettings> {
        let (nets, judge) = (defaults::<train::Args>(), defaults::<train_judge::Args>());
        let (dynamics, dqn) = (defaults::<train_dynamics::Args>(), defaults::<train_dqn::Args>());
        let labels = digest(&data.labels)?;
        Ok(ResultSettings {
            hyperparameters: hyperparameters.clone(),
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            solutions: digest(&data.solutions)?,
            labels_and_variants: format!("{labels} {}", digest(&data.variants)?),
            labels,
            batch: nets.training.batch,
            learning_rate: nets.training.learning_rate,
            decay_epochs: nets.decay_epochs,
            mirror: nets.mirror,
            without_dev: nets.without_dev,
            judge_batch: Some(judge.training.batch),
            judge_learning_rate: Some(judge.training.learning_rate),
            balls_per_scene: Some(judge.balls_per_scene),
            dynamics_batch: Some(dynamics.training.batch),
            dynamics_learning_rate: Some(dynamics.training.learning_rate),
            dynamics_balls_per_scene: Some(dynamics.balls_per_scene),
            imagined_per_scene: Some(dynamics.imagined_per_scene),
            dqn_batch: DQN_BATCH,
            dqn_learning_rate: dqn.training.learning_rate,
            dqn_balls_per_scene: dqn.balls_per_scene,
        })
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
    pub fn load(path: &Path, FoldArgs { setup, fold }: FoldArgs) -> anyhow::Result<Option<FoldResult>> {
        let name = path.display();
        let bytes = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            read => read.with_context(|| format!("cannot read {name}"))?,
        };
        let result: FoldResult = serde_json::from_slice(&bytes)
            .with_context(|| format!("{name} is not a result of `pathlight reproduce`: remove it"))?;
        let Report { setup: found_setup, fold: found_fold, .. } = result.report;
        ensure!(
            (found_setup, found_fold) == (setup, fold),
            "{name} holds the result of {found_setup} {found_fold}: remove it, or name it after that fold"
        );
        Ok(Some(result))
    }

    /// Writes the file, completely or not at all.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn save(&self, path: &Path) -> anyhow::Result<()> {
        replace_file(path, &serde_json::to_vec(self)?)?;
        say(&format!("wrote {}", path.display()));
        Ok(())
    }

    /// The settings it was made with.
    pub fn settings(&self) -> ResultSettings {
        let (card, judge) = (&self.nets.card, self.judge.card.judge.as_ref());
        let (dynamics, dqn) = (self.dynamics.card.dynamics.as_ref(), &self.dqn.card);
        ResultSettings {
            hyperparameters: self.hyperparameters.clone(),
            simulator: self.report.simulator,
            agents_version: self.report.agents_version,
            solutions: self.nets.data.clone(),
            labels: self.judge.data.clone(),
            labels_and_variants: self.dynamics.data.clone(),
            batch: card.batch,
            learning_rate: card.learning_rate,
            decay_epochs: card.decay_epochs,
            mirror: card.mirror,
            without_dev: card.without_dev,
            judge_batch: judge.map(|judge| judge.batch),
            judge_learning_rate: judge.map(|judge| judge.learning_rate),
            balls_per_scene: judge.map(|judge| judge.balls_per_scene),
            dynamics_batch: dynamics.map(|dynamics| dynamics.batch),
            dynamics_learning_rate: dynamics.map(|dynamics| dynamics.learning_rate),
            dynamics_balls_per_scene: dynamics.map(|dynamics| dynamics.balls_per_scene),
            imagined_per_scene: dynamics.map(|dynamics| dynamics.imagined_per_scene),
            dqn_batch: dqn.batch,
            dqn_learning_rate: dqn.learning_rate,
            dqn_balls_per_scene: dqn.balls_per_scene,
        }
    }

    /// The first solving attempts of an agent, on all tasks or those of a template; empty if it was not measured.
    pub fn first_solved(&self, agent: AgentName, template: Option<usize>) -> Vec<Option<usize>> {
        let score = self.report.agents.iter().find(|score| score.agent == agent);
        let all = score.into_iter().flat_map(|score| &score.first_solved);
        all.filter(|(task, _)| template.is_none_or(|one| task.template == one)).map(|&(_, first)| first).collect()
    }

    /// Auccess, and the percentages of tasks solved at the first attempt, within 10 and within 100; `None` if the agent
    /// was not measured.
    pub fn score(&self, agent: AgentName) -> Option<[f64; 4]> {
        let firsts = self.first_solved(agent, None);
        let [one, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved_within(&firsts, attempts));
        (!firsts.is_empty()).then(|| [auccess(&firsts), one, ten, hundred])
    }
}

/// Reads all results in a folder, within before cross, folds ascending.
///
/// # Errors
/// If there is none, a file is damaged, or results have different settings.
pub fn read(folder: &Path) -> anyhow::Result<Vec<FoldResult>> {
    let mut results: Vec<FoldResult> = Vec::new();
    for setup in [Setup::Within, Setup::Cross] {
        for fold in 0..FOLDS {
            let fold = FoldArgs { setup, fold };
            let path = folder.join(format!("{fold}.json"));
            let Some(result) = FoldResult::load(&path, fold)? else { continue };
            if let Some(first) = results.first() {
                let other = result.settings().differences(&first.settings());
                ensure!(
                    other.is_empty(),
                    "{} was made with other settings than the results before it ({other}): keep such results in \
                     different folders (--results)",
                    path.display()
                );
            }
            results.push(result);
        }
    }
    ensure!(!results.is_empty(), "{} holds no results: run `pathlight reproduce` first", folder.display());
    Ok(results)
}
