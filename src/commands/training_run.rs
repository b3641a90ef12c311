//! A training run in a folder: checkpoint, losses, weights. A run that was cut off goes on there with the same
//! result; settings or data that are not the run's own are refused.

use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, bail, ensure};
use pathlight::nets::training::{Module, Trainer};
use pathlight::nets::{Card, PathNet};
use serde::{Deserialize, Serialize};

use super::file_lock::lock;

const NETS: &str = "checkpoint-nets.bpk";
const OPTIMISER: &str = "checkpoint-adam.bpk";
const STATE: &str = "checkpoint.json";
const LOCK: &str = "lock";

/// A trainer, and how far it is.
pub struct TrainingRun<M> {
    folder: PathBuf,
    pub trainer: Trainer<M>,
    state: State,
    started: Instant,
    /// Time that earlier processes have spent on it, s.
    before: f64,
    _held: File,
}

/// What a checkpoint says of its run.
#[derive(Serialize, Deserialize)]
pub struct State {
    pub card: Card,
    /// SHA-256 of the file that is trained on.
    pub data: String,
    /// Batches trained on.
    pub done: usize,
    /// Wall-clock time of training so far, s.
    pub seconds: f64,
    /// Names of the losses.
    pub losses: Vec<String>,
    /// For each checkpoint the epoch, the batches so far, and the mean losses of the batches since the one before.
    pub log: Vec<(usize, usize, Vec<f32>)>,
}

impl<M: Module> TrainingRun<M> {
    /// The run of a folder: from its checkpoint, or with the fresh trainer. `data` is the digest of what it is
    /// trained on, `losses` are the names of what a step gives.
    ///
    /// # Errors
    /// If the folder holds another run, is used by another process, or cannot be written.
    pub fn open(
        folder: PathBuf,
        card: Card,
        data: String,
        losses: &[&str],
        trainer: Trainer<M>,
    ) -> anyhow::Result<TrainingRun<M>> {
        let held = lock(&folder.join(LOCK))?;
        let losses = losses.iter().map(ToString::to_string).collect();
        let fresh = State { card, data, done: 0, seconds: 0.0, losses, log: Vec::new() };
        let name = folder.display();
        let (trainer, state) = match state(&folder)? {
            None => (trainer, fresh),
            Some(found) if found.card != fresh.card => bail!(
                "{name} holds a run with {:?}, now it is {:?}: name another folder with --out",
                found.card,
                fresh.card
            ),
            Some(found) if found.data != fresh.data => {
                bail!("{name} holds a run on other data: name another folder with --out")
            }
            Some(found) => {
                let [nets, optimiser] = files(&folder, found.done);
                (trainer.restore(&nets, &optimiser).with_context(|| format!("{name} is damaged: remove it"))?, found)
            }
        };
        let before = state.seconds;
        Ok(TrainingRun { folder, trainer, state, started: Instant::now(), before, _held: held })
    }

    /// Batches trained on, up to the last checkpoint.
    pub fn done(&self) -> usize {
        self.state.done
    }

    /// Writes the checkpoint after so many batches. The state is written last and names the files, so that a run
    /// cut off in between goes on from the checkpoint before.
    ///
    /// # Errors
    /// If the losses are no numbers any more, or the folder cannot be written.
    pub fn save(&mut self, epoch: usize, done: usize, losses: &[f32]) -> anyhow::Result<()> {
        let name = self.folder.display().to_string();
        ensure!(
            losses.iter().all(|loss| loss.is_finite()),
            "the losses of {name} are no numbers any more after {done} batches: lower --rate or change --seed"
        );
        let [nets, optimiser] = files(&self.folder, done);
        self.trainer.save(&nets, &optimiser)?;
        self.state.done = done;
        self.state.seconds = self.before + self.started.elapsed().as_secs_f64();
        self.state.log.push((epoch, done, losses.to_vec()));
        self.write_state(&[&nets, &optimiser]).with_context(|| format!("cannot write to {name}"))
    }

    /// Replaces the state, writes the losses for people, and removes checkpoints but the newest.
    fn write_state(&self, newest: &[&PathBuf]) -> anyhow::Result<()> {
        fs::write(self.folder.join("next.json"), serde_json::to_vec(&self.state)?)?;
        fs::rename(self.folder.join("next.json"), self.folder.join(STATE))?;
        let mut losses = format!("epoch,batch,{}\n", self.state.losses.join(","));
        for (epoch, done, numbers) in &self.state.log {
            let numbers: Vec<String> = numbers.iter().map(|loss| format!("{loss:.5}")).collect();
            losses.push_str(&format!("{epoch},{done},{}\n", numbers.join(",")));
        }
        fs::write(self.folder.join("losses.csv"), losses)?;
        for file in fs::read_dir(&self.folder)? {
            let file = file?.path();
            let is_checkpoint = file.extension().is_some_and(|extension| extension == "bpk");
            if is_checkpoint && !newest.contains(&&file) {
                fs::remove_file(file)?;
            }
        }
        Ok(())
    }

    /// Writes the weights of the nets, once the run has ended; gives their file.
    ///
    /// # Errors
    /// If the folder cannot be written.
    pub fn finish(&self, nets: &PathNet) -> anyhow::Result<PathBuf> {
        let weights = self.folder.join("weights.safetensors");
        fs::write(&weights, nets.save(&self.state.card)?)
            .with_context(|| format!("cannot write {}", weights.display()))?;
        Ok(weights)
    }
}

/// The files of the checkpoint after so many batches.
fn files(folder: &Path, done: usize) -> [PathBuf; 2] {
    [NETS, OPTIMISER].map(|name| folder.join(format!("{done}-{name}")))
}

/// What the checkpoint in a folder says, if there is one.
///
/// # Errors
/// If it cannot be read.
pub fn state(folder: &Path) -> anyhow::Result<Option<State>> {
    let path = folder.join(STATE);
    match fs::read(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        read => {
            let bytes = read.with_context(|| format!("cannot read {}", path.display()))?;
            let state = serde_json::from_slice(&bytes);
            state.map(Some).with_context(|| format!("{} is damaged: remove it", folder.display()))
        }
    }
}
