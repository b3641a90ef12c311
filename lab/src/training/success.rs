//! Trains the success net, which predicts how likely each ball is to solve, and adds it to the four nets' weights.
//!
//! It learns from labelled balls of the tasks that the four nets were trained on, so that none of the nets in the file
//! has seen other tasks.

use std::path::PathBuf;
use std::slice;

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::weights_file::{ModelFile, training_folder};
use pathlight::nets::training::{SuccessBatch, Trainer};
use pathlight::nets::{SuccessCard, SuccessNet};
use pathlight::raster::scene_coverage;

use super::labelled_scenes::{Drawn, LabelledScenes, Sampling};
use super::settings::{LabelsRecipe, RunSettings};
use super::training_run::{Inputs, TrainingRun};
use crate::data::label::LABELS;
use crate::progress::Progress;

/// What to train.
pub struct Settings {
    pub fold: FoldId,
    /// Weights of the four nets; `None` means the shipped ones.
    pub weights: Option<PathBuf>,
    /// File of labelled balls.
    pub labels: PathBuf,
    /// Passes over the scenes.
    pub epochs: usize,
    pub recipe: LabelsRecipe,
    pub run: RunSettings,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            fold: FoldId::default(),
            weights: None,
            labels: LABELS.into(),
            epochs: 100,
            recipe: LabelsRecipe::default(),
            run: RunSettings::default(),
        }
    }
}

impl Settings {
    /// Starts or continues training. Returns the weights file of all five nets if the run is complete; it leaves out a
    /// dynamics net of the weights.
    ///
    /// # Errors
    /// If the weights or the labels cannot be used, or the folder cannot be continued or written.
    pub fn train(&self, progress: &mut dyn Progress) -> anyhow::Result<Option<PathBuf>> {
        let LabelsRecipe { batch, optimiser, learning_rate, balls_per_scene } = self.recipe;
        let model = ModelFile::read(self.weights.as_deref(), self.fold)?;
        model.check(AgentName::Paper, self.fold)?;
        let ModelFile { mut nets, mut card, digest, .. } = model;
        let scenes = LabelledScenes::read(slice::from_ref(&self.labels), self.fold, card.without_dev)?.of_tasks()?;
        card.dynamics = None;
        card.success = Some(SuccessCard {
            seed: self.run.seed,
            epochs: self.epochs,
            batch,
            balls_per_scene,
            optimiser,
            learning_rate,
            balls: scenes.balls(),
        });
        let folder = self.run.out.clone().unwrap_or_else(|| training_folder(self.fold).join("success"));
        let trainer = Trainer::<SuccessNet>::new(self.run.seed).with_optimiser(optimiser);
        let inputs = Inputs::of(slice::from_ref(&self.labels))?.added_to(digest);
        let mut run = TrainingRun::open(folder, card, inputs, &["success"], trainer, progress)?;
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
        // Agents would use a dynamics net instead.
        (nets.success, nets.dynamics) = (Some(run.trainer.nets()), None);
        run.write_weights(|card| nets.save(card)).map(Some)
    }

    /// Makes a batch of the run, by its number.
    fn batch(&self, scenes: &LabelledScenes, number: usize) -> SuccessBatch {
        let mut batch = SuccessBatch::default();
        let sampling = Sampling::Uniform(self.recipe.balls_per_scene);
        for Drawn { scene, balls, mirrored } in scenes.draw(self.recipe.batch, self.run.seed, sampling, number) {
            let balls = balls.into_iter().map(|ball| scene.balls[ball]);
            let added = batch.add(&scene_coverage(&scene.scene), balls, mirrored);
            added.expect("the balls were checked when they were read");
        }
        batch
    }
}
