//! A training run in a folder: checkpoint, losses and weights. Used by all training commands.
//!
//! An interrupted run continues from its last checkpoint with the same result as an uninterrupted one. A folder whose
//! run has other settings or data is refused.

use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::mpsc::sync_channel;
use std::thread;
use std::time::Instant;

use anyhow::{Context, bail, ensure};
use pathlight::command_line::replace_file::replace_file;
use pathlight::nets::training::{Schedule, Trainable, Trainer};
use pathlight::nets::{Card, WeightsError};
use pathlight::puzzle::utf8::utf8;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::settings::RunSettings;
use crate::files::differences::differences;
use crate::files::digest;
use crate::files::file_lock::lock;
use crate::progress::Progress;

const NETS: &str = "-checkpoint-nets.bpk";
const OPTIMISER: &str = "-checkpoint-optimiser.bpk";
const CHECKPOINT: &str = "checkpoint.json";
const LOCK: &str = "lock";

/// A trainer, and the folder in which its progress is saved. `C` is the card of the weights.
pub struct TrainingRun<M, C = Card> {
    folder: PathBuf,
    pub trainer: Trainer<M>,
    checkpoint: Checkpoint<C>,
    started: Instant,
    /// Time spent by earlier processes, s.
    seconds_before: f64,
    _lock: File,
}

/// The content of `checkpoint.json`; the nets and the state of the optimiser are in separate files.
#[derive(Serialize, Deserialize)]
pub struct Checkpoint<C = Card> {
    pub card: C,
    /// SHA-256 of each file of training data, separated by spaces.
    pub data: String,
    /// SHA-256 of the weights that the nets are added to, if any.
    pub added_to: Option<String>,
    /// Number of batches trained so far.
    pub done: usize,
    /// Wall-clock time of training so far, s.
    pub seconds: f64,
    /// Names of the losses.
    pub losses: Vec<String>,
    /// For each checkpoint, the epoch, the batches so far, and the mean losses since the checkpoint before.
    pub log: Vec<(usize, usize, Vec<f32>)>,
}

/// The digests of the files that a run reads.
pub struct Inputs {
    /// SHA-256 of each file of training data, separated by spaces.
    pub data: String,
    /// SHA-256 of the weights that the nets are added to, if any.
    pub added_to: Option<String>,
}

impl Inputs {
    /// Hashes the training data.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub fn of(data: &[PathBuf]) -> anyhow::Result<Inputs> {
        let digests = data.iter().map(|path| digest(path)).collect::<anyhow::Result<Vec<_>>>()?;
        Ok(Inputs { data: digests.join(" "), added_to: None })
    }

    /// Adds the hash of the weights that the nets are added to.
    pub fn added_to(self, digest: String) -> Inputs {
        Inputs { added_to: Some(digest), ..self }
    }
}

/// How long to train, and at which learning rates.
pub struct Plan {
    pub epochs: usize,
    pub batches_per_epoch: usize,
    pub schedule: Schedule,
}

impl<M: Trainable, C: PartialEq + Serialize + DeserializeOwned> TrainingRun<M, C> {
    /// Opens the run in a folder: continues from its checkpoint, or starts with `trainer`. While another process trains
    /// there, this one waits. `losses` are the names of the losses of a step.
    ///
    /// # Errors
    /// If the folder holds another run, or cannot be written.
    pub fn open(
        folder: PathBuf,
        card: C,
        Inputs { data, added_to }: Inputs,
        losses: &[&str],
        trainer: Trainer<M>,
        progress: &mut dyn Progress,
    ) -> anyhow::Result<TrainingRun<M, C>> {
        let lock = lock(&folder.join(LOCK), progress)?;
        let losses = losses.iter().map(ToString::to_string).collect();
        let fresh = Checkpoint { card, data, added_to, done: 0, seconds: 0.0, losses, log: Vec::new() };
        let name = folder.display();
        let (trainer, checkpoint) = match read_checkpoint(&folder)? {
            None => (trainer, fresh),
            Some(found) if found.card != fresh.card => bail!(
                "{name} holds a run with other settings ({}): use another folder, or remove this one",
                differences(&found.card, &fresh.card)
            ),
            Some(found) if found.data != fresh.data => {
                bail!("{name} holds a run on other data: use another folder, or remove this one")
            }
            Some(found) if found.added_to != fresh.added_to => {
                bail!("{name} holds a run with other --weights: use another folder, or remove this one")
            }
            Some(found) => {
                let [nets, optimiser] = files(&folder, found.done);
                let restored = trainer.restore(&nets, &optimiser);
                (restored.with_context(|| format!("the checkpoint in {name} is damaged: remove the folder"))?, found)
            }
        };
        let seconds_before = checkpoint.seconds;
        Ok(TrainingRun { folder, trainer, checkpoint, started: Instant::now(), seconds_before, _lock: lock })
    }

    /// Trains to the end of the plan or to `settings.stop_after`, and saves checkpoints. `batch` makes a batch from its
    /// number in the run, on another thread while the previous one is trained on. `step` takes an optimiser step on a
    /// batch at a learning rate, and returns the losses. Returns whether the run is complete.
    ///
    /// # Errors
    /// If a loss is not finite, or the folder cannot be written.
    pub fn train<B: Send>(
        &mut self,
        plan: &Plan,
        settings: &RunSettings,
        batch: impl Fn(usize) -> B + Sync,
        mut step: impl FnMut(&mut Trainer<M>, B, f64) -> Vec<f32> + Send,
        progress: &mut dyn Progress,
    ) -> anyhow::Result<bool> {
        let total = plan.batches_per_epoch * plan.epochs;
        let first = self.checkpoint.done;
        let stop = settings.stop_after.map_or(usize::MAX, |batches| first.saturating_add(batches));
        progress.begin(total as u64);
        progress.advance(first as u64, format!("batch {first}"));
        let (mut sums, mut summed) = (vec![0.0; self.checkpoint.losses.len()], 0);
        thread::scope(|scope| {
            let (sender, batches) = sync_channel(1);
            let batch = &batch;
            scope.spawn(move || {
                for number in first..total {
                    // The receiver is gone once the run has stopped.
                    if sender.send(batch(number)).is_err() {
                        return;
                    }
                }
            });
            for (number, batch) in (first..).zip(batches) {
                let (trainer, rate) = (&mut self.trainer, plan.schedule.learning_rate(number, total));
                // Run in rayon's pool: a step from outside would wait for another thread at every layer.
                let losses = rayon::scope(|_| step(trainer, batch, rate));
                let done = number + 1;
                summed += 1;
                for (sum, loss) in sums.iter_mut().zip(losses) {
                    *sum += loss;
                }
                if done.is_multiple_of(settings.checkpoint.into()) || done == total {
                    let means: Vec<f32> = sums.iter().map(|sum| sum / summed as f32).collect();
                    self.save(number / plan.batches_per_epoch, done, &means)?;
                    let (name, loss) = (self.checkpoint.losses.last(), means.last());
                    let (name, loss) = name.zip(loss).context("a step has losses")?;
                    progress.advance(summed, format!("batch {done} of {total}, {name} loss {loss:.4}"));
                    (sums, summed) = (vec![0.0; means.len()], 0);
                    if done >= stop {
                        break;
                    }
                }
            }
            anyhow::Ok(())
        })?;
        let done = self.checkpoint.done;
        progress.finish(&match done == total {
            true => format!("{total} batches"),
            false => format!("stopped at batch {done} of {total}, as requested,"),
        });
        Ok(done == total)
    }

    /// Saves a checkpoint after `done` batches. `checkpoint.json` is written last and names the other files, so that a
    /// run interrupted in between continues from the previous checkpoint.
    fn save(&mut self, epoch: usize, done: usize, losses: &[f32]) -> anyhow::Result<()> {
        let name = self.folder.display().to_string();
        ensure!(
            losses.iter().all(|loss| loss.is_finite()),
            "the loss became NaN or infinite after {done} batches in {name}: lower --learning-rate or change --seed"
        );
        let [nets, optimiser] = files(&self.folder, done);
        self.trainer.save(&nets, &optimiser).with_context(|| format!("cannot write to {name}"))?;
        self.checkpoint.done = done;
        self.checkpoint.seconds = self.seconds_before + self.started.elapsed().as_secs_f64();
        self.checkpoint.log.push((epoch, done, losses.to_vec()));
        self.write_checkpoint(&[&nets, &optimiser]).with_context(|| format!("cannot write to {name}"))
    }

    /// Writes the losses as CSV, then replaces `checkpoint.json`, and removes the run's older checkpoints. A run
    /// interrupted in between writes the losses again.
    fn write_checkpoint(&self, newest: &[&PathBuf]) -> anyhow::Result<()> {
        let mut losses = format!("epoch,batch,{}\n", self.checkpoint.losses.join(","));
        for (epoch, done, means) in &self.checkpoint.log {
            let means: Vec<String> = means.iter().map(|loss| format!("{loss:.5}")).collect();
            losses.push_str(&format!("{epoch},{done},{}\n", means.join(",")));
        }
        replace_file(&self.folder.join("losses.csv"), losses.as_bytes())?;
        replace_file(&self.folder.join(CHECKPOINT), &serde_json::to_vec(&self.checkpoint)?)?;
        for file in fs::read_dir(&self.folder)? {
            let file = file?.path();
            if is_checkpoint(&file) && !newest.contains(&&file) {
                fs::remove_file(file)?;
            }
        }
        Ok(())
    }

    /// Writes the weights of a complete run, which `save` makes from its card. Returns their file.
    ///
    /// # Errors
    /// If they cannot be saved, or the folder cannot be written.
    pub fn write_weights(&self, save: impl FnOnce(&C) -> Result<Vec<u8>, WeightsError>) -> anyhow::Result<PathBuf> {
        let weights = self.folder.join("weights.safetensors");
        replace_file(&weights, &save(&self.checkpoint.card)?)?;
        Ok(weights)
    }
}

/// Returns the files of the checkpoint after a number of batches.
fn files(folder: &Path, done: usize) -> [PathBuf; 2] {
    [NETS, OPTIMISER].map(|suffix| folder.join(format!("{done}{suffix}")))
}

/// Whether `files` could have named a file. Other files in the folder are left alone.
fn is_checkpoint(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let number = [NETS, OPTIMISER].iter().find_map(|suffix| name.strip_suffix(suffix));
    number.is_some_and(|number| number.parse::<usize>().is_ok())
}

/// Reads the `checkpoint.json` of a folder, if there is one.
///
/// # Errors
/// If the file cannot be read.
fn read_checkpoint<C: DeserializeOwned>(folder: &Path) -> anyhow::Result<Option<Checkpoint<C>>> {
    let path = folder.join(CHECKPOINT);
    match fs::read(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        read => {
            let bytes = read.with_context(|| format!("cannot read {}", path.display()))?;
            let text = utf8(&bytes).with_context(|| format!("cannot read {}", path.display()))?;
            let checkpoint = serde_json::from_str(text);
            checkpoint.map(Some).with_context(|| format!("{} is damaged: remove its folder", path.display()))
        }
    }
}
