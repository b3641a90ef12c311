//! DQN's result beside that of a setup and fold, `dqn/SETUP-FOLD.json`: a file of its own, because DQN is trained and
//! measured without the nets of the row, and may be added to it later.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, ensure};
use pathlight::nets::DqnCard;
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use crate::commands::agent_name::AgentName;
use crate::commands::differences::differences;
use crate::commands::dqn_args::DqnArgs;
use crate::commands::evaluate::{self, Report};
use crate::commands::fold_args::FoldArgs;
use crate::commands::progress::say;
use crate::commands::replace_file::replace_file;
use crate::commands::training_args::TrainingArgs;
use crate::commands::training_run::{Checkpoint, read_checkpoint};
use crate::commands::{defaults, train_dqn};

/// Scenes in a batch: fewer than the other nets take, so that a short training has more steps.
const BATCH: u16 = 16;

/// The result of DQN on a setup and fold.
#[derive(Serialize, Deserialize)]
pub struct DqnResult {
    pub training: Checkpoint<DqnCard>,
    /// Size of the weights, bytes.
    pub weights: u64,
    /// Wall-clock time of the evaluation, s.
    pub evaluation_seconds: f64,
    /// Most test tasks of a template.
    pub limit: u16,
    /// DQN and the random agent.
    pub report: Report,
}

/// What determines a result, apart from setup, fold and balls. Results belong in one table if these agree.
#[derive(PartialEq, Serialize)]
pub struct DqnSettings {
    seed: u64,
    epochs: usize,
    batch: u16,
    balls_per_scene: u16,
    learning_rate: f64,
    without_dev: bool,
    limit: u16,
    simulator: u32,
}

/// What to make a result with.
pub struct DqnPlan<'a> {
    pub seed: u64,
    pub epochs: u16,
    pub limit: u16,
    pub labels: &'a Path,
}

/// The file of DQN's result among the results in a folder.
fn file(results: &Path, fold: FoldArgs) -> PathBuf {
    results.join("dqn").join(format!("{fold}.json"))
}

impl DqnPlan<'_> {
    /// Makes DQN's result of a fold with the other commands, and prints those that a person would type for it, unless its
    /// file exists. Continues where it was interrupted.
    ///
    /// # Errors
    /// If the file was made with other settings, and the errors of the commands.
    pub fn make(&self, fold: FoldArgs, results: &Path, folder: &Path) -> anyhow::Result<()> {
        let path = file(results, fold);
        let name = path.display();
        if let Some(result) = DqnResult::load(results, fold)? {
            let other = differences(&result.settings(), &self.settings());
            ensure!(
                other.is_empty(),
                "{name} was made with other settings ({other}): remove it, or choose another folder"
            );
            say(&format!("{name} exists"));
            return Ok(());
        }
        let made = self.run(fold, folder).with_context(|| format!("cannot make {name}"))?;
        replace_file(&path, &serde_json::to_vec(&made)?)?;
        say(&format!("wrote {name}"));
        Ok(())
    }

    fn run(&self, fold: FoldArgs, folder: &Path) -> anyhow::Result<DqnResult> {
        let &DqnPlan { seed, epochs, limit, labels } = self;
        let announce = |command: &str, options: String| {
            let FoldArgs { setup, fold } = fold;
            say(&format!("$ pathlight {command} --setup {setup} --fold {fold} --seed {seed} {options}"));
        };
        let (balls, out) = (labels.display(), folder.display());
        announce("train-dqn", format!("--labels {balls} --epochs {epochs} --batch {BATCH} --out {out}"));
        let training = TrainingArgs { seed, batch: BATCH, out: Some(folder.to_path_buf()), ..defaults() };
        let labels = vec![labels.to_path_buf()];
        train_dqn::Args { fold, labels, epochs: epochs.into(), training, ..defaults() }.run()?;

        let started = Instant::now();
        let weights = folder.join("weights.safetensors");
        announce("evaluate", format!("--agent dqn --dqn {} --limit {limit}", weights.display()));
        let dqn = DqnArgs { dqn: Some(weights.clone()) };
        let agents = vec![AgentName::Dqn];
        let report = evaluate::Args { agents, fold, limit: Some(limit), seed, dqn, ..defaults() }.measure()?;
        say(report.table()?.trim_end());
        Ok(DqnResult {
            training: read_checkpoint(folder)?.with_context(|| format!("no run in {}", folder.display()))?,
            weights: fs::metadata(&weights)?.len(),
            evaluation_seconds: started.elapsed().as_secs_f64(),
            limit,
            report,
        })
    }

    /// The settings of a result made now.
    fn settings(&self) -> DqnSettings {
        let defaults = defaults::<train_dqn::Args>();
        DqnSettings {
            seed: self.seed,
            epochs: self.epochs.into(),
            batch: BATCH,
            balls_per_scene: defaults.balls_per_scene,
            learning_rate: defaults.training.learning_rate,
            without_dev: defaults.without_dev,
            limit: self.limit,
            simulator: simulator::VERSION,
        }
    }
}

impl DqnResult {
    /// Reads the result of a fold; `None` if there is no file.
    ///
    /// # Errors
    /// If the file is not a result, or the result of another fold.
    pub fn load(results: &Path, fold: FoldArgs) -> anyhow::Result<Option<DqnResult>> {
        let path = file(results, fold);
        let name = path.display();
        let bytes = match fs::read(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            read => read.with_context(|| format!("cannot read {name}"))?,
        };
        let result: DqnResult = serde_json::from_slice(&bytes)
            .with_context(|| format!("{name} is not a result of `pathlight reproduce`: remove it"))?;
        let (setup, number) = (result.report.setup, result.report.fold);
        ensure!(
            (setup, number) == (fold.setup, fold.fold),
            "{name} holds the result of {setup} {number}: remove it, or name it after that fold"
        );
        Ok(Some(result))
    }

    /// The settings it was made with.
    pub fn settings(&self) -> DqnSettings {
        let DqnCard { seed, epochs, batch, balls_per_scene, learning_rate, without_dev, .. } = self.training.card;
        let (limit, simulator) = (self.limit, self.report.simulator);
        DqnSettings { seed, epochs, batch, balls_per_scene, learning_rate, without_dev, limit, simulator }
    }
}
