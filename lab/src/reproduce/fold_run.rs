//! Makes the result of one setup and fold: trains its nets, and evaluates their agents.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::{Optimiser, PathWeights};
use serde::de::DeserializeOwned;

use super::fold_result::{DataFiles, FoldResult, Hyperparameters};
use super::recipes::Recipes;
use crate::data::label::{Scenes, read_labels};
use crate::files::digest;
use crate::files::quoted::quoted;
use crate::measure::agents::{Weights, measured_with};
use crate::measure::evaluate;
use crate::measure::report::Report;
use crate::progress::Progress;
use crate::training::dynamics::{self, DynamicsRecipe};
use crate::training::settings::{LabelsRecipe, RunSettings};
use crate::training::training_run::{Checkpoint, read_checkpoint};
use crate::training::{dqn, paths, success};

/// Epochs of the four nets. Every weights file holds them, but no agent measured here uses them, so one is enough.
const FOUR_NETS_EPOCHS: u16 = 1;

/// Trains and evaluates a fold in a folder of its own, and reports the equivalent commands. Continues where it was
/// interrupted.
///
/// # Errors
/// If the labelled balls are not those of the hyperparameters, and the errors of training and evaluation.
pub fn run(
    fold: FoldId,
    hyperparameters: &Hyperparameters,
    data: &DataFiles,
    folder: &Path,
    progress: &mut dyn Progress,
) -> anyhow::Result<FoldResult> {
    let run = FoldRun { fold, hyperparameters, data, folder };
    run.check_data()?;
    let recipes = Recipes::of(fold.setup);
    run.train_nets(progress)?;
    run.train_success(recipes.success, progress)?;
    run.train_dynamics(recipes.dynamics, progress)?;
    run.train_dqn(recipes.dqn, progress)?;
    let started = Instant::now();
    let report = run.evaluate(progress)?;
    Ok(FoldResult {
        hyperparameters: hyperparameters.clone(),
        solutions: digest(&data.solutions)?,
        success: trained(&run.folder_of(Net::Success))?,
        dynamics: trained(&run.folder_of(Net::Dynamics))?,
        dqn: trained(&run.folder_of(Net::Dqn))?,
        evaluation_seconds: Some(started.elapsed().as_secs_f64()),
        threads: rayon::current_num_threads(),
        report,
    })
}

/// The nets that are trained in one folder of the run.
#[derive(Clone, Copy)]
enum Net {
    Four,
    Success,
    Dynamics,
    Dqn,
}

impl Net {
    /// The command of `train` that trains it.
    fn command(self) -> &'static str {
        match self {
            Net::Four => "paths",
            Net::Success => "success",
            Net::Dynamics => "dynamics",
            Net::Dqn => "dqn",
        }
    }
}

struct FoldRun<'a> {
    fold: FoldId,
    hyperparameters: &'a Hyperparameters,
    data: &'a DataFiles,
    folder: &'a Path,
}

impl FoldRun<'_> {
    fn check_data(&self) -> anyhow::Result<()> {
        let (path, rounds) = (&self.data.labels, self.hyperparameters.label_rounds);
        let labelled = read_labels(path)?;
        ensure!(
            labelled.scenes == Scenes::Tasks && labelled.proposer.is_none(),
            "{} holds other balls than --labels takes: it takes those that `pathlight-lab data label` sampled",
            path.display(),
        );
        ensure!(
            labelled.rounds() == Some(rounds.into()),
            "{} does not hold the balls of {rounds} rounds: run `pathlight-lab reproduce --only data`, or change \
             --label-rounds",
            path.display(),
        );
        Ok(())
    }

    fn train_nets(&self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let files = format!("--solutions {}", quoted(&self.data.solutions));
        self.announce(Net::Four, &files, FOUR_NETS_EPOCHS, progress);
        let settings = paths::Settings {
            fold: self.fold,
            solutions: self.data.solutions.clone(),
            epochs: FOUR_NETS_EPOCHS.into(),
            run: self.run_settings(Net::Four),
            ..paths::Settings::default()
        };
        say_weights(settings.train(progress)?, progress)
    }

    fn train_success(&self, recipe: LabelsRecipe, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let epochs = self.hyperparameters.epochs;
        let options = format!("{} --optimiser {}", self.weights_and_labels(), optimiser_option(recipe.optimiser));
        self.announce(Net::Success, &options, epochs, progress);
        let settings = success::Settings {
            fold: self.fold,
            weights: Some(self.weights(Net::Four)),
            labels: self.data.labels.clone(),
            epochs: epochs.into(),
            recipe,
            run: self.run_settings(Net::Success),
        };
        say_weights(settings.train(progress)?, progress)
    }

    fn train_dynamics(&self, recipe: DynamicsRecipe, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let epochs = self.hyperparameters.epochs;
        let DynamicsRecipe { optimiser, path_weights: PathWeights { all, solving }, .. } = recipe;
        let options = format!(
            "{} --optimiser {} --path-weight {all} --solving-path-weight {solving}",
            self.weights_and_labels(),
            optimiser_option(optimiser)
        );
        self.announce(Net::Dynamics, &options, epochs, progress);
        let settings = dynamics::Settings {
            fold: self.fold,
            weights: Some(self.weights(Net::Four)),
            labels: vec![self.data.labels.clone()],
            epochs: epochs.into(),
            recipe,
            run: self.run_settings(Net::Dynamics),
            ..dynamics::Settings::default()
        };
        say_weights(settings.train(progress)?, progress)
    }

    fn train_dqn(&self, recipe: LabelsRecipe, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let epochs = self.hyperparameters.dqn_epochs;
        let options = format!("--labels {} --batch {}", quoted(&self.data.labels), recipe.batch);
        self.announce(Net::Dqn, &options, epochs, progress);
        let settings = dqn::Settings {
            fold: self.fold,
            labels: vec![self.data.labels.clone()],
            epochs: epochs.into(),
            recipe,
            run: self.run_settings(Net::Dqn),
            ..dqn::Settings::default()
        };
        say_weights(settings.train(progress)?, progress)
    }

    /// Measures the agents of the dynamics net and of DQN, then that of the success net.
    fn evaluate(&self, progress: &mut dyn Progress) -> anyhow::Result<Report> {
        let agents = measured_with(Weights::Dynamics).chain(measured_with(Weights::Dqn)).collect();
        let mut report = self.evaluate_with(Net::Dynamics, agents, Some(self.weights(Net::Dqn)), progress)?;
        let success = measured_with(Weights::Success).collect();
        let of_success_net = self.evaluate_with(Net::Success, success, None, progress)?;
        // The random agent is in both.
        report.agents.retain(|score| score.agent != AgentName::Random);
        report.agents.extend(of_success_net.agents);
        report.agents.sort_by_key(|score| score.agent as usize);
        progress.say(report.table()?.trim_end());
        Ok(report)
    }

    /// Measures agents with the weights of a net, and with DQN's.
    fn evaluate_with(
        &self,
        net: Net,
        agents: Vec<AgentName>,
        dqn: Option<PathBuf>,
        progress: &mut dyn Progress,
    ) -> anyhow::Result<Report> {
        let &Hyperparameters { seed, limit, .. } = self.hyperparameters;
        let weights = self.weights(net);
        let named: String = agents.iter().map(|agent| format!(" --agent {agent}")).collect();
        let dqn_option = dqn.as_deref().map(|path| format!(" --dqn {}", quoted(path))).unwrap_or_default();
        let options = format!("--weights {}{dqn_option}{named} --limit {limit}", quoted(&weights));
        self.say("measure evaluate", &options, progress);
        let settings = evaluate::Settings {
            agents,
            fold: self.fold,
            limit: Some(limit),
            seed,
            weights: Some(weights),
            dqn,
            ..evaluate::Settings::default()
        };
        settings.measure(progress)
    }

    fn folder_of(&self, net: Net) -> PathBuf {
        match net {
            Net::Four => self.folder.to_path_buf(),
            added => self.folder.join(added.command()),
        }
    }

    fn weights(&self, net: Net) -> PathBuf {
        self.folder_of(net).join("weights.safetensors")
    }

    /// The options of a net that is added to the four nets and learns from the labelled balls.
    fn weights_and_labels(&self) -> String {
        format!("--weights {} --labels {}", quoted(&self.weights(Net::Four)), quoted(&self.data.labels))
    }

    fn run_settings(&self, net: Net) -> RunSettings {
        RunSettings { seed: self.hyperparameters.seed, out: Some(self.folder_of(net)), ..RunSettings::default() }
    }

    /// Says which training begins.
    fn announce(&self, net: Net, options: &str, epochs: u16, progress: &mut dyn Progress) {
        let options = format!("{options} --epochs {epochs} --out {}", quoted(&self.folder_of(net)));
        self.say(&format!("train {}", net.command()), &options, progress);
    }

    fn say(&self, command: &str, options: &str, progress: &mut dyn Progress) {
        let FoldId { setup, fold } = self.fold;
        let seed = self.hyperparameters.seed;
        progress.say(&format!("$ pathlight-lab {command} --setup {setup} --fold {fold} --seed {seed} {options}"));
    }
}

/// What `--optimiser` takes.
fn optimiser_option(optimiser: Optimiser) -> String {
    optimiser.to_string().to_lowercase()
}

/// Says where the weights of a run are; a run here is never stopped before its end.
fn say_weights(weights: Option<PathBuf>, progress: &mut dyn Progress) -> anyhow::Result<()> {
    let weights = weights.context("the run was stopped")?;
    progress.say(&format!("the weights are in {}", weights.display()));
    Ok(())
}

/// The complete run of a folder.
fn trained<C: DeserializeOwned>(folder: &Path) -> anyhow::Result<Checkpoint<C>> {
    read_checkpoint(folder)?.with_context(|| format!("no run in {}", folder.display()))
}
