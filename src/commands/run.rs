//! A training run in a folder: checkpoint, losses, weights. A run that was cut off goes on there with the same
//! result; settings that are not the run's own are refused.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, ensure};
use pathlight::pathnet::trainer::{Module, Trainer};
use pathlight::pathnet::{Card, PathNet};
use serde::{Deserialize, Serialize};

const NETS: &str = "checkpoint-nets.bpk";
const OPTIMISER: &str = "checkpoint-adam.bpk";
const STATE: &str = "checkpoint.json";
const LOSSES: &str = "losses.csv";
const WEIGHTS: &str = "weights.safetensors";

/// A trainer, and how far it is.
pub struct Run<M> {
    folder: PathBuf,
    card: Card,
    pub trainer: Trainer<M>,
    /// Batches trained on.
    pub done: usize,
    /// The batch of the checkpoint that is on disk.
    kept: Option<usize>,
    /// Time that earlier processes have spent on it, s.
    before: f64,
    started: Instant,
}

/// What a checkpoint says of its run.
#[derive(Serialize, Deserialize)]
pub struct State {
    pub card: Card,
    /// Batches trained on.
    pub done: usize,
    /// Wall-clock time of training so far, s.
    pub seconds: f64,
}

impl<M: Module> Run<M> {
    /// The run of a folder: from its checkpoint, or with the fresh trainer. `losses` names the columns.
    ///
    /// # Errors
    /// If the folder holds another run, or cannot be written.
    pub fn open(folder: PathBuf, card: Card, losses: &str, trainer: Trainer<M>) -> anyhow::Result<Run<M>> {
        fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
        let mut run = Run { folder, card, trainer, done: 0, kept: None, before: 0.0, started: Instant::now() };
        let Some(state) = state(&run.folder)? else {
            fs::write(run.folder.join(LOSSES), format!("epoch,batch,{losses}\n"))?;
            return Ok(run);
        };
        ensure!(
            state.card == run.card,
            "{} holds a run with {:?}, now it is {:?}: name another folder with --out",
            run.folder.display(),
            state.card,
            run.card
        );
        let [nets, optimiser] = run.files(state.done);
        run.trainer = run.trainer.restore(&nets, &optimiser)?;
        (run.done, run.kept, run.before) = (state.done, Some(state.done), state.seconds);
        Ok(run)
    }

    /// Writes the checkpoint and a line of losses. The state is written last and names the files, so that a run
    /// cut off in between goes on from the checkpoint before.
    ///
    /// # Errors
    /// If the folder cannot be written.
    pub fn save(&mut self, epoch: usize, losses: &[f32]) -> anyhow::Result<()> {
        let Run { done, ref folder, .. } = *self;
        let [nets, optimiser] = self.files(done);
        self.trainer.save(&nets, &optimiser)?;
        let seconds = self.before + self.started.elapsed().as_secs_f64();
        let state = State { card: self.card.clone(), done, seconds };
        fs::write(folder.join("next.json"), serde_json::to_vec(&state)?)?;
        fs::rename(folder.join("next.json"), folder.join(STATE))?;
        let losses: String = losses.iter().map(|loss| format!(",{loss:.5}")).collect();
        let mut log = OpenOptions::new().append(true).open(folder.join(LOSSES))?;
        log.write_all(format!("{epoch},{done}{losses}\n").as_bytes())?;
        if let Some(before) = self.kept.replace(done).filter(|&before| before != done) {
            for file in self.files(before) {
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
        let weights = self.folder.join(WEIGHTS);
        fs::write(&weights, nets.save(&self.card)).with_context(|| format!("cannot write {}", weights.display()))?;
        Ok(weights)
    }

    /// The files of the checkpoint after so many batches.
    fn files(&self, done: usize) -> [PathBuf; 2] {
        [NETS, OPTIMISER].map(|name| self.folder.join(format!("{done}-{name}")))
    }
}

/// What the checkpoint in a folder says, if there is one.
///
/// # Errors
/// If it is damaged.
pub fn state(folder: &Path) -> anyhow::Result<Option<State>> {
    let Ok(state) = fs::read(folder.join(STATE)) else { return Ok(None) };
    let state = serde_json::from_slice(&state);
    state.map(Some).with_context(|| format!("{} is damaged: remove it", folder.display()))
}

/// The losses of a run, a line for each checkpoint, under the names of the columns.
///
/// # Errors
/// If there are none.
pub fn losses(folder: &Path) -> anyhow::Result<String> {
    let path = folder.join(LOSSES);
    fs::read_to_string(&path).with_context(|| format!("no losses in {}: train again", path.display()))
}
