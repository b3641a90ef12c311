//! `pathlight train`: the four nets trained jointly on the solutions of a fold's training tasks.
//!
//! The run lives in a folder (`run`). What a step does, `pathnet::trainer` says.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;

use anyhow::ensure;
use pathlight::dataset::samples::Sample;
use pathlight::dataset::solutions::Solution;
use pathlight::nets::training::{Batch, Trainer};
use pathlight::nets::{Card, PathNet, flex};
use pathlight::simulator;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::collect::{Collected, read_solutions};
use super::digest;
use super::fold_args::FoldArgs;
use super::progress::Progress;
use super::scene_cache::SceneCache;
use super::training_run::TrainingRun;

/// Train the four nets on the training tasks of a fold
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    which: FoldArgs,

    /// Solutions to train on, from `pathlight collect`
    #[arg(long, default_value = "assets/solutions.jsonl")]
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

    /// Of these passes, the last so many in which the learning rate falls to nothing
    #[arg(long, value_name = "EPOCHS", default_value_t = 1)]
    cool: usize,

    /// Show half of the samples mirrored left to right: PHYRE's world is symmetric
    #[arg(long)]
    mirror: bool,

    /// Leave the dev tasks out, to choose settings by them
    #[arg(long)]
    without_dev: bool,

    /// Batches between two checkpoints, and between two lines of losses
    #[arg(long, value_name = "BATCHES", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..))]
    checkpoint: u16,

    /// End this run after so many batches, at a checkpoint; the same command goes on from there
    #[arg(long, value_name = "BATCHES")]
    stop_after: Option<usize>,

    /// Seed of the initial weights and of the order of the samples
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let folder = self.out.clone().unwrap_or_else(|| self.which.folder());
        let (samples, card) = self.samples()?;
        let trainer = Trainer::<PathNet>::new(flex(), self.seed);
        let data = digest(&self.solutions)?;
        let mut run = TrainingRun::open(folder, card, data, &["base", "target", "action", "placement"], trainer)?;
        let batches = samples.len().div_ceil(self.batch.into());
        let total = batches * self.epochs;
        let mut progress = Progress::new(Some(total as u64));
        let first = run.done();
        progress.advance(first as u64, format!("batch {first}"));
        let interval = usize::from(self.checkpoint);
        let stop = self.stop_after.map_or(usize::MAX, |batches| first + batches);
        let (mut sums, mut summed) = ([0.0; 4], 0);
        let mut done = first;
        thread::scope(|scope| {
            // While one batch is trained on, the next is drawn.
            let (ready, next) = sync_channel(1);
            let (this, samples) = (&self, &samples);
            scope.spawn(move || this.draw(samples, first..total, ready));
            for batch in next {
                let left = (total - done) as f64 / (batches * self.cool) as f64;
                let losses = run.trainer.step(batch, self.rate * left.min(1.0));
                done += 1;
                summed += 1;
                for (sum, loss) in sums.iter_mut().zip(losses) {
                    *sum += loss;
                }
                if done.is_multiple_of(interval) || done == total {
                    let losses = sums.map(|sum| sum / summed as f32);
                    run.save((done - 1) / batches, done, &losses)?;
                    let so_far = format!("batch {done} of {total}, placement loss {:.4}", losses[3]);
                    progress.advance(summed, so_far);
                    (sums, summed) = ([0.0; 4], 0);
                    if done >= stop {
                        break;
                    }
                }
            }
            anyhow::Ok(())
        })?;
        if done < total {
            progress.finish(&format!("batch {done} of {total}: stopped as told"));
            return Ok(());
        }
        let weights = run.finish(&run.trainer.nets())?;
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
        let fold = self.which.tasks();
        let tasks = if self.without_dev { fold.train } else { fold.all_train() };
        let Collected { solutions, simulator: version, .. } = read_solutions(&self.solutions)?;
        ensure!(
            version == simulator::VERSION,
            "the solutions are of simulator {version}, this is simulator {}: collect them again",
            simulator::VERSION
        );
        let mut chosen: Vec<Solution> =
            solutions.into_iter().filter(|solution| tasks.binary_search(&solution.task).is_ok()).collect();
        ensure!(!chosen.is_empty(), "{} holds no solutions of this fold", self.solutions.display());
        chosen.sort_by_key(|solution| solution.task);
        let scenes = SceneCache::new();
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
            learning_rate: self.rate,
            decay_epochs: self.cool,
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
