//! `pathlight train`: the four nets trained jointly on the solutions of a fold's training tasks.
//!
//! The run lives in a folder (checkpoint, losses, weights) from which it goes on if it was cut off, with the same
//! result. What a step does, `pathnet::trainer` says.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;

use anyhow::{Context, ensure};
use pathlight::pathnet::trainer::{Batch, Trainer};
use pathlight::pathnet::{Card, PathNet, device};
use pathlight::samples::Sample;
use pathlight::simulator;
use pathlight::solutions::Solution;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::collect::read_solutions;
use super::progress::Progress;
use super::scenes::Scenes;
use super::which::Which;

/// Train the four nets on the training tasks of a fold
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    which: Which,

    /// Solutions to train on, from `pathlight collect`
    #[arg(long, default_value = "target/solutions.jsonl")]
    solutions: PathBuf,

    /// Folder of the run: checkpoint, losses.csv, weights.safetensors [default: target/train/SETUP-FOLD]
    #[arg(long)]
    out: Option<PathBuf>,

    /// Passes over the samples
    #[arg(long, default_value_t = 10)]
    epochs: usize,

    /// Samples in a batch
    #[arg(long, default_value_t = 32, value_parser = clap::value_parser!(u16).range(1..))]
    batch: u16,

    /// Learning rate of Adam
    #[arg(long, default_value_t = 3e-3)]
    rate: f64,

    /// Show half of the samples mirrored left to right: PHYRE's world is symmetric
    #[arg(long)]
    mirror: bool,

    /// Batches between two checkpoints, and between two lines of losses
    #[arg(long, value_name = "BATCHES", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..))]
    checkpoint: u16,

    /// End this run after so many batches, at a checkpoint; the same command goes on from there
    #[arg(long, value_name = "BATCHES")]
    stop_after: Option<usize>,

    /// Seed of the initial weights and of the order of the samples
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// What the nets run on: flex or ndarray
    #[arg(long, default_value = "flex")]
    device: String,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let name = format!("target/train/{}-{}", self.which.setup, self.which.fold);
        let folder = self.out.clone().unwrap_or_else(|| PathBuf::from(name));
        fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
        let (samples, card) = self.samples()?;
        let device = device(&self.device).map_err(anyhow::Error::msg)?;
        let mut run = Run::open(&folder, &card, Trainer::<PathNet>::new(device, self.seed))?;
        let batches = samples.len().div_ceil(self.batch.into());
        let total = batches * self.epochs;
        let mut progress = Progress::new(Some(total as u64));
        progress.advance(run.done as u64, format!("batch {}", run.done));
        let interval = usize::from(self.checkpoint);
        let stop = self.stop_after.map_or(usize::MAX, |batches| run.done + batches);
        let mut sums = [0.0; 4];
        let first = run.done;
        thread::scope(|scope| {
            // While one batch is trained on, the next is drawn.
            let (ready, next) = sync_channel(1);
            let (this, samples) = (&self, &samples);
            scope.spawn(move || this.draw(samples, first..total, ready));
            for batch in next {
                let losses = run.trainer.step(batch, self.rate);
                run.done += 1;
                for (sum, loss) in sums.iter_mut().zip(losses) {
                    *sum += loss / f32::from(self.checkpoint);
                }
                if run.done.is_multiple_of(interval) {
                    run.save(&folder, &card, (run.done - 1) / batches, sums)?;
                    let so_far = format!("batch {} of {total}, placement loss {:.4}", run.done, sums[3]);
                    progress.advance(interval as u64, so_far);
                    sums = [0.0; 4];
                    if run.done >= stop {
                        break;
                    }
                }
            }
            anyhow::Ok(())
        })?;
        if run.done < total {
            progress.finish(&format!("batch {} of {total}: stopped as told", run.done));
            return Ok(());
        }
        let weights = folder.join("weights.safetensors");
        fs::write(&weights, run.trainer.nets().save(&card))
            .with_context(|| format!("cannot write {}", weights.display()))?;
        progress.finish(&format!("{total} batches; weights are in {},", weights.display()));
        Ok(())
    }

    /// Draws these batches of the run, one after the other, until nobody waits for them.
    fn draw(&self, samples: &[Sample], wanted: Range<usize>, ready: SyncSender<Batch>) {
        let size = usize::from(self.batch);
        let batches = samples.len().div_ceil(size);
        for epoch in wanted.start / batches..wanted.end.div_ceil(batches) {
            let order = self.order(samples.len(), epoch);
            for chosen in order.chunks(size).skip(wanted.start.saturating_sub(epoch * batches)) {
                let batch = Batch::new(chosen.iter().map(|&(sample, mirrored)| (&samples[sample], mirrored)));
                if ready.send(batch).is_err() {
                    return;
                }
            }
        }
    }

    /// The samples of the fold's training tasks, and what they were made with.
    fn samples(&self) -> anyhow::Result<(Vec<Sample>, Card)> {
        let tasks = self.which.tasks().all_train();
        let (solutions, version) = read_solutions(&self.solutions)?;
        ensure!(
            version == simulator::VERSION,
            "the solutions are of simulator {version}, this is simulator {}: collect them again",
            simulator::VERSION
        );
        let mut chosen: Vec<Solution> =
            solutions.into_iter().filter(|solution| tasks.binary_search(&solution.task).is_ok()).collect();
        ensure!(!chosen.is_empty(), "{} holds no solutions of this fold", self.solutions.display());
        chosen.sort_by_key(|solution| solution.task);
        let scenes = Scenes::new();
        eprintln!("drawing {} solutions", chosen.len());
        let samples = chosen
            .par_iter()
            .map(|solution| Ok(Sample::new(scenes.get(solution.task)?, solution.ball)?))
            .collect::<anyhow::Result<Vec<Sample>>>()?;
        let card = Card {
            setup: self.which.setup,
            fold: self.which.fold,
            seed: self.seed,
            epochs: self.epochs,
            batch: self.batch,
            rate: self.rate,
            mirror: self.mirror,
            samples: samples.len(),
            tasks: chosen.chunk_by(|a, b| a.task == b.task).count(),
            simulator: version,
            judge: None,
        };
        Ok((samples, card))
    }

    /// The order of the samples in an epoch, and whether each is mirrored.
    fn order(&self, samples: usize, epoch: usize) -> Vec<(usize, bool)> {
        let mut rng = Pcg64Mcg::seed_from_u64(self.seed.wrapping_mul(1000).wrapping_add(epoch as u64));
        let mut order: Vec<_> = (0..samples).map(|sample| (sample, self.mirror && rng.random())).collect();
        order.shuffle(&mut rng);
        order
    }
}

/// A training run: the trainer, and how many batches it has seen.
struct Run {
    trainer: Trainer<PathNet>,
    done: usize,
    /// The batch of the checkpoint that is on disk.
    kept: Option<usize>,
}

const NETS: &str = "checkpoint-nets.bpk";
const OPTIMISER: &str = "checkpoint-adam.bpk";
const STATE: &str = "checkpoint.json";

impl Run {
    /// The run of a folder: its checkpoint, or the fresh trainer.
    fn open(folder: &Path, card: &Card, trainer: Trainer<PathNet>) -> anyhow::Result<Run> {
        let Ok(state) = fs::read(folder.join(STATE)) else {
            fs::write(folder.join("losses.csv"), "epoch,batch,base,target,action,placement,sum\n")?;
            return Ok(Run { trainer, done: 0, kept: None });
        };
        let (found, done): (Card, usize) =
            serde_json::from_slice(&state).with_context(|| format!("{} is damaged: remove it", folder.display()))?;
        ensure!(
            found == *card,
            "{} holds a run with {found:?}, now it is {card:?}: name another folder with --out",
            folder.display()
        );
        let [nets, optimiser] = files(folder, done);
        Ok(Run { trainer: trainer.restore(&nets, &optimiser)?, done, kept: Some(done) })
    }

    /// Writes the checkpoint and a line of losses. The state is written last and names the files, so that a run
    /// cut off in between goes on from the checkpoint before.
    fn save(&mut self, folder: &Path, card: &Card, epoch: usize, losses: [f32; 4]) -> anyhow::Result<()> {
        let done = self.done;
        let [nets, optimiser] = files(folder, done);
        self.trainer.save(&nets, &optimiser)?;
        fs::write(folder.join("next.json"), serde_json::to_vec(&(card, done))?)?;
        fs::rename(folder.join("next.json"), folder.join(STATE))?;
        if let Some(before) = self.kept.replace(done) {
            for file in files(folder, before) {
                fs::remove_file(file)?;
            }
        }
        let [base, target, action, placement] = losses;
        let sum: f32 = losses.iter().sum();
        let line = format!("{epoch},{done},{base:.5},{target:.5},{action:.5},{placement:.5},{sum:.5}\n");
        OpenOptions::new().append(true).open(folder.join("losses.csv"))?.write_all(line.as_bytes())?;
        Ok(())
    }
}

/// The files of the checkpoint after so many batches.
fn files(folder: &Path, done: usize) -> [PathBuf; 2] {
    [NETS, OPTIMISER].map(|name| folder.join(format!("{done}-{name}")))
}
