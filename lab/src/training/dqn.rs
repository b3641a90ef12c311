//! Trains DQN, the benchmark's baseline, on labelled balls, and writes it to a separate weights file.
//!
//! As published (Bakhtin et al. 2019), the loss is binary cross-entropy on batches of which half are solutions. Unlike
//! there, each scene is balanced, many balls share one encoding of a scene, and scenes are mirrored.

use std::path::PathBuf;

use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::weights_file::training_folder;
use pathlight::nets::training::{DqnBatch, Trainer};
use pathlight::nets::{Dqn, DqnCard};
use pathlight::raster::scene_coverage;

use super::labelled_scenes::{Drawn, LabelledScenes, Sampling};
use super::settings::{LabelsRecipe, RunSettings};
use super::training_run::{Inputs, TrainingRun};
use crate::data::label::LABELS;
use crate::progress::Progress;

/// What to train.
pub struct Settings {
    pub fold: FoldId,
    /// Files of labelled balls.
    pub labels: Vec<PathBuf>,
    /// Passes over the scenes.
    pub epochs: usize,
    /// Half of the balls of each scene in a batch are solutions.
    pub recipe: LabelsRecipe,
    /// Train without the fold's dev tasks, so that settings can be chosen on them.
    pub without_dev: bool,
    pub run: RunSettings,
}

impl Default for Settings {
    fn default() -> Settings {
        let recipe = LabelsRecipe { balls_per_scene: 64, ..LabelsRecipe::default() };
        let run = RunSettings::default();
        Settings { fold: FoldId::default(), labels: vec![LABELS.into()], epochs: 15, recipe, without_dev: false, run }
    }
}

impl Settings {
    /// Starts or continues training. Returns the weights file if the run is complete.
    ///
    /// # Errors
    /// If the labels cannot be used, or the folder cannot be continued or written.
    pub fn train(&self, progress: &mut dyn Progress) -> anyhow::Result<Option<PathBuf>> {
        let LabelsRecipe { batch, optimiser, learning_rate, balls_per_scene } = self.recipe;
        let scenes = LabelledScenes::read(&self.labels, self.fold, self.without_dev)?.of_tasks()?;
        let card = DqnCard {
            setup: self.fold.setup,
            fold: self.fold.fold,
            seed: self.run.seed,
            epochs: self.epochs,
            batch,
            balls_per_scene,
            optimiser,
            learning_rate,
            balls: scenes.balls(),
            without_dev: self.without_dev,
        };
        let folder = self.run.out.clone().unwrap_or_else(|| training_folder(self.fold).join("dqn"));
        let trainer = Trainer::<Dqn>::new(self.run.seed).with_optimiser(optimiser);
        let mut run = TrainingRun::open(folder, card, Inputs::of(&self.labels)?, &["dqn"], trainer, progress)?;
        let complete = run.train(
            &scenes.plan(self.epochs, batch, learning_rate),
            &self.run,
            |number| self.batch(&scenes, number),
            |trainer, batch, learning_rate| vec![trainer.step(batch, learning_rate)],
            progress,
        )?;
        if !complete {
            return Ok(None);
        }
        run.write_weights(|card| run.trainer.nets().save(card)).map(Some)
    }

    /// Makes a batch of the run, by its number.
    fn batch(&self, scenes: &LabelledScenes, number: usize) -> DqnBatch {
        let mut batch = DqnBatch::default();
        let sampling = Sampling::Balanced(self.recipe.balls_per_scene);
        for Drawn { scene, balls, mirrored } in scenes.draw(self.recipe.batch, self.run.seed, sampling, number) {
            let balls = balls.into_iter().map(|ball| scene.balls[ball]);
            batch.add(&scene_coverage(&scene.scene), balls, mirrored);
        }
        batch
    }
}
