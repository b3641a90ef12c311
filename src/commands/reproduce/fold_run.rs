//! Runs one setup and fold with the other commands: trains the nets and the judge, and evaluates the agents.

use std::fs;
use std::path::Path;
use std::time::Instant;

use anyhow::{Context, ensure};
use pathlight::benchmark::folds::Setup;

use super::fold_result::{DataFiles, FoldResult, Hyperparameters};
use crate::commands::fold_args::FoldArgs;
use crate::commands::label::read_labels;
use crate::commands::model_args::ModelArgs;
use crate::commands::progress::say;
use crate::commands::training_args::TrainingArgs;
use crate::commands::training_run::read_checkpoint;
use crate::commands::{defaults, evaluate, train, train_judge};

/// Trains and evaluates a fold in a folder of its own, and prints the commands that a person would type for it.
/// Continues where it was interrupted.
///
/// # Errors
/// If the labelled balls are not those of the hyperparameters, and the errors of the commands.
pub fn run(
    fold: FoldArgs,
    hyperparameters: &Hyperparameters,
    data: &DataFiles,
    folder: &Path,
) -> anyhow::Result<FoldResult> {
    let &Hyperparameters { seed, label_rounds, epochs, limit, .. } = hyperparameters;
    ensure!(
        read_labels(&data.labels)?.rounds() == Some(label_rounds.into()),
        "{} does not hold the balls of {label_rounds} rounds: run `pathlight reproduce --only data`, or change \
         --label-rounds",
        data.labels.display(),
    );
    let judge_epochs = match fold.setup {
        Setup::Within => hyperparameters.judge_epochs,
        Setup::Cross => hyperparameters.judge_epochs_cross,
    };
    let judge_folder = folder.join("judge");
    let (nets, judge_weights) = (folder.join("weights.safetensors"), judge_folder.join("weights.safetensors"));
    let announce = |command: &str, options: String| {
        let FoldArgs { setup, fold } = fold;
        say(&format!("$ pathlight {command} --setup {setup} --fold {fold} --seed {seed} {options}"));
    };

    let (solutions, out) = (data.solutions.display(), folder.display());
    announce("train", format!("--solutions {solutions} --epochs {epochs} --out {out}"));
    let training = |folder: &Path| TrainingArgs { seed, out: Some(folder.to_path_buf()), ..defaults() };
    let (solutions, epochs) = (data.solutions.clone(), epochs.into());
    train::Args { fold, solutions, epochs, training: training(folder), ..defaults() }.run()?;

    let (weights, labels, out) = (nets.display(), data.labels.display(), judge_folder.display());
    let options = format!("--weights {weights} --labels {labels} --epochs {judge_epochs} --out {out}");
    announce("train-judge", options);
    let (model, labels) = (ModelArgs { weights: Some(nets) }, data.labels.clone());
    let (epochs, training) = (judge_epochs.into(), training(&judge_folder));
    train_judge::Args { fold, model, labels, epochs, training, ..defaults() }.run()?;

    let started = Instant::now();
    announce("evaluate", format!("--weights {} --limit {limit}", judge_weights.display()));
    let model = ModelArgs { weights: Some(judge_weights.clone()) };
    let report = evaluate::Args { fold, limit: Some(limit), seed, model, ..defaults() }.measure()?;
    say(report.table()?.trim_end());

    let trained = |folder: &Path| read_checkpoint(folder)?.with_context(|| format!("no run in {}", folder.display()));
    Ok(FoldResult {
        hyperparameters: hyperparameters.clone(),
        nets: trained(folder)?,
        judge: trained(&judge_folder)?,
        weights: fs::metadata(&judge_weights)?.len(),
        evaluation_seconds: started.elapsed().as_secs_f64(),
        threads: Some(rayon::current_num_threads()),
        report,
        dqn: None,
    })
}
