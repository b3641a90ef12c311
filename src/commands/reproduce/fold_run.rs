//! Runs one setup and fold with the other commands: trains all nets, and evaluates all agents.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, ensure};
use pathlight::benchmark::folds::Setup;
use serde::de::DeserializeOwned;

use super::fold_result::{DQN_BATCH, DataFiles, FoldResult, Hyperparameters};
use crate::commands::agent_name::AgentName;
use crate::commands::dqn_args::DqnArgs;
use crate::commands::evaluate::{self, Report};
use crate::commands::fold_args::FoldArgs;
use crate::commands::label::read_labels;
use crate::commands::model_args::ModelArgs;
use crate::commands::progress::say;
use crate::commands::training_args::TrainingArgs;
use crate::commands::training_run::{Checkpoint, read_checkpoint};
use crate::commands::{defaults, train, train_dqn, train_dynamics, train_judge};

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
    let run = FoldRun { fold, hyperparameters, data, folder };
    run.check_data()?;
    run.train_nets()?;
    run.train_judge()?;
    run.train_dynamics()?;
    run.train_dqn()?;
    let started = Instant::now();
    let report = run.evaluate()?;
    let size = |net| fs::metadata(run.weights(net)).map(|file| file.len());
    Ok(FoldResult {
        hyperparameters: hyperparameters.clone(),
        nets: trained(folder)?,
        judge: trained(&run.folder_of(Net::Judge))?,
        dynamics: trained(&run.folder_of(Net::Dynamics))?,
        dqn: trained(&run.folder_of(Net::Dqn))?,
        weights: size(Net::Dynamics)?,
        dqn_weights: size(Net::Dqn)?,
        evaluation_seconds: started.elapsed().as_secs_f64(),
        threads: rayon::current_num_threads(),
        report,
    })
}

/// What a folder of the run holds the training of.
#[derive(Clone, Copy)]
enum Net {
    Four,
    Judge,
    Dynamics,
    Dqn,
}

struct FoldRun<'a> {
    fold: FoldArgs,
    hyperparameters: &'a Hyperparameters,
    data: &'a DataFiles,
    folder: &'a Path,
}

impl FoldRun<'_> {
    fn check_data(&self) -> anyhow::Result<()> {
        let (data, &Hyperparameters { label_rounds, variant_rounds, .. }) = (self.data, self.hyperparameters);
        let files = [(&data.labels, label_rounds, "label", false), (&data.variants, variant_rounds, "variant", true)];
        for (path, rounds, option, variants) in files {
            let labelled = read_labels(path)?;
            ensure!(
                labelled.variants == variants && !labelled.proposed,
                "{} holds other balls than --{option}s takes: it takes those that `pathlight label{}` sampled",
                path.display(),
                if variants { " --variants" } else { "" },
            );
            ensure!(
                labelled.rounds() == Some(rounds.into()),
                "{} does not hold the balls of {rounds} rounds: run `pathlight reproduce --only data`, or change \
                 --{option}-rounds",
                path.display(),
            );
        }
        Ok(())
    }

    fn train_nets(&self) -> anyhow::Result<()> {
        let (solutions, epochs) = (self.data.solutions.clone(), self.hyperparameters.epochs);
        self.announce("train", &format!("--solutions {}", solutions.display()), epochs, Net::Four);
        let training = self.training(Net::Four);
        train::Args { fold: self.fold, solutions, epochs: epochs.into(), training, ..defaults() }.run()
    }

    fn train_judge(&self) -> anyhow::Result<()> {
        let (weights, labels) = (self.weights(Net::Four), self.data.labels.clone());
        let epochs = match self.fold.setup {
            Setup::Within => self.hyperparameters.judge_epochs,
            Setup::Cross => self.hyperparameters.judge_epochs_cross,
        };
        let files = format!("--weights {} --labels {}", weights.display(), labels.display());
        self.announce("train-judge", &files, epochs, Net::Judge);
        let (model, training) = (ModelArgs { weights: Some(weights) }, self.training(Net::Judge));
        train_judge::Args { fold: self.fold, model, labels, epochs: epochs.into(), training, ..defaults() }.run()
    }

    /// Starts from the judge.
    fn train_dynamics(&self) -> anyhow::Result<()> {
        let (weights, epochs) = (self.weights(Net::Judge), self.hyperparameters.dynamics_epochs);
        let labels = vec![self.data.labels.clone(), self.data.variants.clone()];
        let [all, variants] = [&self.data.labels, &self.data.variants].map(|path| path.display());
        let files = format!("--weights {} --labels {all} --labels {variants}", weights.display());
        self.announce("train-dynamics", &files, epochs, Net::Dynamics);
        let (model, training) = (ModelArgs { weights: Some(weights) }, self.training(Net::Dynamics));
        train_dynamics::Args { fold: self.fold, model, labels, epochs: epochs.into(), training, ..defaults() }.run()
    }

    fn train_dqn(&self) -> anyhow::Result<()> {
        let (labels, epochs) = (vec![self.data.labels.clone()], self.hyperparameters.dqn_epochs);
        let options = format!("--labels {} --batch {DQN_BATCH}", self.data.labels.display());
        self.announce("train-dqn", &options, epochs, Net::Dqn);
        let training = TrainingArgs { batch: DQN_BATCH, ..self.training(Net::Dqn) };
        train_dqn::Args { fold: self.fold, labels, epochs: epochs.into(), training, ..defaults() }.run()
    }

    /// Measures all agents: those of the dynamics net and DQN, then judge and four nets.
    fn evaluate(&self) -> anyhow::Result<Report> {
        let &Hyperparameters { seed, limit, .. } = self.hyperparameters;
        let of = |net| evaluate::Args {
            fold: self.fold,
            limit: Some(limit),
            seed,
            model: ModelArgs { weights: Some(self.weights(net)) },
            ..defaults()
        };
        let agents = [AgentName::Online, AgentName::OnlineByBalls, AgentName::Dynamics, AgentName::Dqn];
        let named = agents.map(|agent| format!("--agent {agent}")).join(" ");
        let [judge, dynamics, dqn] = [Net::Judge, Net::Dynamics, Net::Dqn].map(|net| self.weights(net));
        let (weights, of_dqn) = (dynamics.display(), dqn.display());
        self.say("evaluate", &format!("--weights {weights} --dqn {of_dqn} {named} --limit {limit}"));
        let dqn = DqnArgs { dqn: Some(dqn.clone()) };
        let mut report = evaluate::Args { agents: agents.to_vec(), dqn, ..of(Net::Dynamics) }.measure()?;
        self.say("evaluate", &format!("--weights {} --limit {limit}", judge.display()));
        let of_judge = of(Net::Judge).measure()?;
        // The random agent is in both.
        report.agents.retain(|score| score.agent != AgentName::Random);
        report.agents.extend(of_judge.agents);
        report.agents.sort_by_key(|score| score.agent as usize);
        say(report.table()?.trim_end());
        Ok(report)
    }

    fn folder_of(&self, net: Net) -> PathBuf {
        match net {
            Net::Four => self.folder.to_path_buf(),
            Net::Judge => self.folder.join("judge"),
            Net::Dynamics => self.folder.join("dynamics"),
            Net::Dqn => self.folder.join("dqn"),
        }
    }

    fn weights(&self, net: Net) -> PathBuf {
        self.folder_of(net).join("weights.safetensors")
    }

    fn training(&self, net: Net) -> TrainingArgs {
        TrainingArgs { seed: self.hyperparameters.seed, out: Some(self.folder_of(net)), ..defaults() }
    }

    /// Says which training begins.
    fn announce(&self, command: &str, options: &str, epochs: u16, net: Net) {
        self.say(command, &format!("{options} --epochs {epochs} --out {}", self.folder_of(net).display()));
    }

    fn say(&self, command: &str, options: &str) {
        let (FoldArgs { setup, fold }, seed) = (self.fold, self.hyperparameters.seed);
        say(&format!("$ pathlight {command} --setup {setup} --fold {fold} --seed {seed} {options}"));
    }
}

/// The complete run of a folder.
fn trained<C: DeserializeOwned>(folder: &Path) -> anyhow::Result<Checkpoint<C>> {
    read_checkpoint(folder)?.with_context(|| format!("no run in {}", folder.display()))
}
