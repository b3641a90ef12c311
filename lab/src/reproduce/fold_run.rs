//! Makes the result of one setup and fold: trains all nets, and evaluates all agents.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::{FoldId, Setup};
use serde::de::DeserializeOwned;

use super::fold_result::{DataFiles, FoldResult, Hyperparameters, Recipes};
use crate::data::label::{Scenes, read_labels};
use crate::files::quoted::quoted;
use crate::measure::agents::{Weights, measured_with};
use crate::measure::evaluate;
use crate::measure::report::Report;
use crate::progress::Progress;
use crate::training::settings::RunSettings;
use crate::training::training_run::{Checkpoint, read_checkpoint};
use crate::training::{dqn, dynamics, paths, success};

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
    let recipes = Recipes::default();
    run.train_nets(&recipes, progress)?;
    run.train_success(&recipes, progress)?;
    run.train_dynamics(&recipes, progress)?;
    run.train_dqn(&recipes, progress)?;
    let started = Instant::now();
    let report = run.evaluate(progress)?;
    let size = |net| fs::metadata(run.weights(net)).map(|file| file.len());
    Ok(FoldResult {
        hyperparameters: hyperparameters.clone(),
        nets: trained(folder)?,
        success: trained(&run.folder_of(Net::Success))?,
        dynamics: trained(&run.folder_of(Net::Dynamics))?,
        dqn: trained(&run.folder_of(Net::Dqn))?,
        weights: size(Net::Dynamics)?,
        dqn_weights: size(Net::Dqn)?,
        evaluation_seconds: started.elapsed().as_secs_f64(),
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

struct FoldRun<'a> {
    fold: FoldId,
    hyperparameters: &'a Hyperparameters,
    data: &'a DataFiles,
    folder: &'a Path,
}

impl FoldRun<'_> {
    fn check_data(&self) -> anyhow::Result<()> {
        let (data, &Hyperparameters { label_rounds, variant_rounds, .. }) = (self.data, self.hyperparameters);
        let files = [
            (&data.labels, label_rounds, "label", Scenes::Tasks),
            (&data.variants, variant_rounds, "variant", Scenes::Variants),
        ];
        for (path, rounds, option, scenes) in files {
            let labelled = read_labels(path)?;
            ensure!(
                labelled.scenes == scenes && labelled.proposer.is_none(),
                "{} holds other balls than --{option}s takes: it takes those that `pathlight-lab data label{}` sampled",
                path.display(),
                if scenes == Scenes::Variants { " --variants" } else { "" },
            );
            ensure!(
                labelled.rounds() == Some(rounds.into()),
                "{} does not hold the balls of {rounds} rounds: run `pathlight-lab reproduce --only data`, or change \
                 --{option}-rounds",
                path.display(),
            );
        }
        Ok(())
    }

    fn train_nets(&self, recipes: &Recipes, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let epochs = self.hyperparameters.epochs;
        self.announce("paths", &format!("--solutions {}", quoted(&self.data.solutions)), epochs, Net::Four, progress);
        let settings = paths::Settings {
            fold: self.fold,
            solutions: self.data.solutions.clone(),
            epochs: epochs.into(),
            recipe: recipes.nets.clone(),
            run: self.run_settings(Net::Four),
        };
        say_weights(settings.train(progress)?, progress)
    }

    fn train_success(&self, recipes: &Recipes, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let weights = self.weights(Net::Four);
        let epochs = match self.fold.setup {
            Setup::Within => self.hyperparameters.success_epochs,
            Setup::Cross => self.hyperparameters.success_epochs_cross,
        };
        let files = format!("--weights {} --labels {}", quoted(&weights), quoted(&self.data.labels));
        self.announce("success", &files, epochs, Net::Success, progress);
        let settings = success::Settings {
            fold: self.fold,
            weights: Some(weights),
            labels: self.data.labels.clone(),
            epochs: epochs.into(),
            recipe: recipes.success.clone().expect("it is trained"),
            run: self.run_settings(Net::Success),
        };
        say_weights(settings.train(progress)?, progress)
    }

    /// Starts from the success net.
    fn train_dynamics(&self, recipes: &Recipes, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let weights = self.weights(Net::Success);
        let epochs = self.hyperparameters.dynamics_epochs;
        let [all, variants] = [&self.data.labels, &self.data.variants].map(|path| quoted(path));
        let files = format!("--weights {} --labels {all} --labels {variants}", quoted(&weights));
        self.announce("dynamics", &files, epochs, Net::Dynamics, progress);
        let settings = dynamics::Settings {
            fold: self.fold,
            weights: Some(weights),
            labels: vec![self.data.labels.clone(), self.data.variants.clone()],
            epochs: epochs.into(),
            recipe: recipes.dynamics.clone().expect("it is trained"),
            run: self.run_settings(Net::Dynamics),
            ..dynamics::Settings::default()
        };
        say_weights(settings.train(progress)?, progress)
    }

    fn train_dqn(&self, recipes: &Recipes, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let epochs = self.hyperparameters.dqn_epochs;
        let options = format!("--labels {} --batch {}", quoted(&self.data.labels), recipes.dqn.batch);
        self.announce("dqn", &options, epochs, Net::Dqn, progress);
        let settings = dqn::Settings {
            fold: self.fold,
            labels: vec![self.data.labels.clone()],
            epochs: epochs.into(),
            recipe: recipes.dqn.clone(),
            run: self.run_settings(Net::Dqn),
            ..dqn::Settings::default()
        };
        say_weights(settings.train(progress)?, progress)
    }

    /// Measures all agents: those of the dynamics net and DQN, then those of the success net and the four nets.
    fn evaluate(&self, progress: &mut dyn Progress) -> anyhow::Result<Report> {
        let dqn = self.weights(Net::Dqn);
        let option = format!(" --dqn {}", quoted(&dqn));
        let agents: Vec<AgentName> = measured_with(Weights::Dynamics).chain(measured_with(Weights::Dqn)).collect();
        let mut report = self.evaluate_with(Net::Dynamics, agents, Some(dqn), &option, progress)?;
        let of_success_net =
            self.evaluate_with(Net::Success, measured_with(Weights::Success).collect(), None, "", progress)?;
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
        option: &str,
        progress: &mut dyn Progress,
    ) -> anyhow::Result<Report> {
        let &Hyperparameters { seed, limit, .. } = self.hyperparameters;
        let weights = self.weights(net);
        let named: String = agents.iter().map(|agent| format!(" --agent {agent}")).collect();
        let options = format!("--weights {}{option}{named} --limit {limit}", quoted(&weights));
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
            Net::Success => self.folder.join("success"),
            Net::Dynamics => self.folder.join("dynamics"),
            Net::Dqn => self.folder.join("dqn"),
        }
    }

    fn weights(&self, net: Net) -> PathBuf {
        self.folder_of(net).join("weights.safetensors")
    }

    fn run_settings(&self, net: Net) -> RunSettings {
        RunSettings { seed: self.hyperparameters.seed, out: Some(self.folder_of(net)), ..RunSettings::default() }
    }

    /// Says which training begins.
    fn announce(&self, net_name: &str, options: &str, epochs: u16, net: Net, progress: &mut dyn Progress) {
        let options = format!("{options} --epochs {epochs} --out {}", quoted(&self.folder_of(net)));
        self.say(&format!("train {net_name}"), &options, progress);
    }

    fn say(&self, command: &str, options: &str, progress: &mut dyn Progress) {
        let FoldId { setup, fold } = self.fold;
        let seed = self.hyperparameters.seed;
        progress.say(&format!("$ pathlight-lab {command} --setup {setup} --fold {fold} --seed {seed} {options}"));
    }
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
