//! `pathlight train`: trains the four nets jointly on the solutions of a fold's training tasks.
//!
//! `training_run` keeps the run in a folder; `nets::training` takes the optimiser steps.

use std::path::PathBuf;

use anyhow::ensure;
use pathlight::dataset::samples::Sample;
use pathlight::dataset::solutions::Solution;
use pathlight::nets::training::{Batch, Schedule, Trainer};
use pathlight::nets::{Card, PathNet};
use pathlight::puzzle::task::Task;
use pathlight::simulator;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::collect::{Collected, read_solutions};
use super::digest;
use super::fold_args::FoldArgs;
use super::progress::say;
use super::training_args::{TrainingArgs, epochs};
use super::training_run::{Plan, TrainingRun};

/// Train the four nets on the training tasks of a fold
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub fold: FoldArgs,

    /// Solutions to train on, from `pathlight collect`
    #[arg(long, default_value = "assets/solutions.jsonl")]
    pub solutions: PathBuf,

    /// Passes over the samples
    #[arg(long, default_value_t = 10, value_parser = epochs())]
    pub epochs: usize,

    /// Number of final epochs over which the learning rate decays linearly to zero
    #[arg(long, value_name = "EPOCHS", default_value_t = 1)]
    pub decay_epochs: usize,

    /// Show half of the samples mirrored left to right: PHYRE's world is symmetric
    #[arg(long)]
    pub mirror: bool,

    /// Leave the dev tasks out of training, so that settings can be chosen on them with `evaluate --dev`
    #[arg(long)]
    pub without_dev: bool,

    #[command(flatten)]
    pub training: TrainingArgs,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let folder = self.training.out.clone().unwrap_or_else(|| self.fold.folder());
        let (samples, card) = self.samples()?;
        let trainer = Trainer::<PathNet>::new(self.training.seed);
        let data = digest(&self.solutions)?;
        let mut run = TrainingRun::open(folder, card, data, &["base", "target", "action", "placement"], trainer)?;
        let batches_per_epoch = samples.len().div_ceil(self.training.batch.into());
        let decay_steps = batches_per_epoch * self.decay_epochs;
        let schedule = Schedule::LinearDecay { peak: self.training.learning_rate, decay_steps };
        let plan = Plan { epochs: self.epochs, batches_per_epoch, schedule };
        let complete = run.train(
            &plan,
            &self.training,
            |number| self.batch(&samples, number),
            |trainer, batch, learning_rate| trainer.step(batch, learning_rate).to_vec(),
        )?;
        if complete {
            say(&format!("the weights are in {}", run.write_weights(|card| run.trainer.nets().save(card))?.display()));
        }
        Ok(())
    }

    /// A batch of the run; it depends only on the seed and its number.
    fn batch(&self, samples: &[Sample], number: usize) -> Batch {
        let size = usize::from(self.training.batch);
        let batches_per_epoch = samples.len().div_ceil(size);
        let order = self.order(samples.len(), number / batches_per_epoch);
        let chosen = order.chunks(size).nth(number % batches_per_epoch).unwrap_or_default();
        Batch::new(chosen.iter().map(|&(sample, mirrored)| (&samples[sample], mirrored)))
    }

    /// The order of the samples in an epoch, and whether each is mirrored.
    fn order(&self, samples: usize, epoch: usize) -> Vec<(usize, bool)> {
        let mut rng = Pcg64Mcg::seed_from_u64(self.training.seed.wrapping_mul(1000).wrapping_add(epoch as u64));
        let mut order: Vec<_> = (0..samples).map(|sample| (sample, self.mirror && rng.random())).collect();
        order.shuffle(&mut rng);
        order
    }

    /// The samples of the fold's training tasks, and the card of nets trained on them.
    fn samples(&self) -> anyhow::Result<(Vec<Sample>, Card)> {
        let tasks = self.fold.training_tasks(self.without_dev);
        let Collected { solutions, simulator: version, .. } = read_solutions(&self.solutions)?;
        let name = self.solutions.display();
        ensure!(
            version == simulator::VERSION,
            "the solutions in {name} were found by simulator {version}, this is simulator {}: collect them again",
            simulator::VERSION
        );
        let mut chosen: Vec<Solution> =
            solutions.into_iter().filter(|solution| tasks.binary_search(&solution.task).is_ok()).collect();
        ensure!(!chosen.is_empty(), "{name} holds no solutions of the training tasks of {}", self.fold);
        chosen.sort_by_key(|solution| solution.task);
        say(&format!("making training images of {} solutions", chosen.len()));
        let samples = chosen
            .par_iter()
            .map(|solution| Ok(Sample::new(&Task::load(solution.task)?.scene, solution.ball)?))
            .collect::<anyhow::Result<Vec<Sample>>>()?;
        let card = Card {
            setup: self.fold.setup,
            fold: self.fold.fold,
            seed: self.training.seed,
            epochs: self.epochs,
            batch: self.training.batch,
            learning_rate: self.training.learning_rate,
            decay_epochs: self.decay_epochs,
            mirror: self.mirror,
            without_dev: self.without_dev,
            samples: samples.len(),
            tasks: chosen.chunk_by(|a, b| a.task == b.task).count(),
            simulator: version,
            judge: None,
            dynamics: None,
        };
        Ok((samples, card))
    }
}
