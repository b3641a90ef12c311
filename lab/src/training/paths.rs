//! Trains the four nets jointly on the solutions of a fold's training tasks.

use std::path::PathBuf;
use std::slice;

use anyhow::ensure;
use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::weights_file::training_folder;
use pathlight::nets::training::{PathsBatch, Sample, Schedule, Trainer};
use pathlight::nets::{Card, PathNet};
use pathlight::puzzle::action::{Ball, Invalid};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::Task;
use pathlight::raster::{ball_image, path_image, scene_channels};
use pathlight::simulator::{self, simulate};
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::labelled_scenes::training_tasks;
use super::settings::{PathsRecipe, RunSettings};
use super::training_run::{Inputs, Plan, TrainingRun};
use crate::data::collect::{SOLUTIONS, read_solutions};
use crate::data::solutions::Solution;
use crate::progress::Progress;

/// What to train.
pub struct Settings {
    pub fold: FoldId,
    /// Solutions to train on.
    pub solutions: PathBuf,
    /// Passes over the samples.
    pub epochs: usize,
    pub recipe: PathsRecipe,
    pub run: RunSettings,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            fold: FoldId::default(),
            solutions: SOLUTIONS.into(),
            epochs: 10,
            recipe: PathsRecipe::default(),
            run: RunSettings::default(),
        }
    }
}

impl Settings {
    /// Starts or continues training. Returns the weights file if the run is complete.
    ///
    /// # Errors
    /// If the solutions cannot be used, or the folder cannot be continued or written.
    pub fn train(&self, progress: &mut dyn Progress) -> anyhow::Result<Option<PathBuf>> {
        ensure!(
            self.recipe.decay_epochs <= self.epochs,
            "the learning rate cannot decay over {} epochs in a run of {}: lower --decay-epochs",
            self.recipe.decay_epochs,
            self.epochs
        );
        let folder = self.run.out.clone().unwrap_or_else(|| training_folder(self.fold));
        let (solutions, card) = self.solutions()?;
        let trainer = Trainer::<PathNet>::new(self.run.seed);
        let inputs = Inputs::of(slice::from_ref(&self.solutions))?;
        let mut run =
            TrainingRun::open(folder, card, inputs, &["base", "target", "action", "placement"], trainer, progress)?;
        progress.say(&format!("making training images of {} solutions", solutions.len()));
        let samples = solutions
            .par_iter()
            .map(|solution| Ok(sample(&Task::load(solution.task)?.scene, solution.ball)?))
            .collect::<anyhow::Result<Vec<Sample>>>()?;
        let batches_per_epoch = samples.len().div_ceil(self.recipe.batch.into());
        let decay_steps = batches_per_epoch * self.recipe.decay_epochs;
        let schedule = Schedule::LinearDecay { peak: self.recipe.learning_rate, decay_steps };
        let plan = Plan { epochs: self.epochs, batches_per_epoch, schedule };
        let complete = run.train(
            &plan,
            &self.run,
            |number| self.batch(&samples, number),
            |trainer, batch, learning_rate| trainer.step(batch, learning_rate).to_vec(),
            progress,
        )?;
        if !complete {
            return Ok(None);
        }
        run.write_weights(|card| run.trainer.nets().save(card)).map(Some)
    }

    /// Makes a batch of the run, which depends only on the seed and the number of the batch.
    fn batch(&self, samples: &[Sample], number: usize) -> PathsBatch {
        let size = usize::from(self.recipe.batch);
        let batches_per_epoch = samples.len().div_ceil(size);
        let order = self.order(samples.len(), number / batches_per_epoch);
        let chosen = order.chunks(size).nth(number % batches_per_epoch).unwrap_or_default();
        PathsBatch::new(chosen.iter().map(|&(sample, mirrored)| (&samples[sample], mirrored)))
    }

    /// The order of the samples in an epoch, and whether each is mirrored.
    fn order(&self, samples: usize, epoch: usize) -> Vec<(usize, bool)> {
        let mut rng = Pcg64Mcg::seed_from_u64(self.run.seed.wrapping_mul(1000).wrapping_add(epoch as u64));
        let mut order: Vec<_> = (0..samples).map(|sample| (sample, self.recipe.mirror && rng.random())).collect();
        order.shuffle(&mut rng);
        order
    }

    /// The solutions of the fold's training tasks, and the card of nets trained on them.
    fn solutions(&self) -> anyhow::Result<(Vec<Solution>, Card)> {
        let PathsRecipe { batch, learning_rate, decay_epochs, mirror, without_dev } = self.recipe;
        let tasks = training_tasks(self.fold, without_dev);
        let solutions = read_solutions(&self.solutions)?;
        let mut chosen: Vec<Solution> =
            solutions.into_iter().filter(|solution| tasks.binary_search(&solution.task).is_ok()).collect();
        ensure!(
            !chosen.is_empty(),
            "{} holds no solutions of the training tasks of {}: name another file with --solutions",
            self.solutions.display(),
            self.fold
        );
        chosen.sort_by_key(|solution| solution.task);
        let card = Card {
            setup: self.fold.setup,
            fold: self.fold.fold,
            seed: self.run.seed,
            epochs: self.epochs,
            batch,
            learning_rate,
            decay_epochs,
            mirror,
            without_dev,
            samples: chosen.len(),
            tasks: chosen.chunk_by(|a, b| a.task == b.task).count(),
            simulator: simulator::VERSION,
            success: None,
            dynamics: None,
        };
        Ok((chosen, card))
    }
}

/// Returns the sample of a ball that solves a scene, from two rollouts: one without the ball and one with it.
///
/// # Errors
/// If the ball is invalid in the scene.
pub fn sample(scene: &Scene, ball: Ball) -> Result<Sample, Invalid> {
    let (without, with) = (simulate(scene, None)?, simulate(scene, Some(ball))?);
    let object = &scene.bodies[scene.body1];
    let targets = [
        path_image(object, &without, scene.body1),
        path_image(object, &with, scene.body1),
        path_image(&ball.body(), &with, scene.bodies.len()),
        ball_image(ball),
    ];
    Ok(Sample { scene: scene_channels(scene), targets })
}
