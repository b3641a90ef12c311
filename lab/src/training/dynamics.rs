//! Trains the dynamics net, which imagines the paths and outcomes of balls, and adds it to the weights of the four
//! nets, where it replaces a success net.
//!
//! It learns from no test task of the fold that the four nets were trained on, so that none of the nets in the file has
//! seen one.

use std::path::{Path, PathBuf};

use anyhow::ensure;
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::weights_file::{ModelFile, training_folder};
use pathlight::nets::training::{DynamicsBatch, Trainer};
use pathlight::nets::{DynamicsCard, DynamicsNet, LearnedFrom, Optimiser, PathWeights};
use pathlight::raster::scene_coverage;

use super::labelled_scenes::{Drawn, LabelledScenes, Sampling};
use super::settings::{BATCH, LEARNING_RATE, RunSettings};
use super::training_run::{Inputs, TrainingRun};
use crate::data::label::LABELS;
use crate::progress::Progress;

/// What to train.
pub struct Settings {
    pub fold: FoldId,
    /// Weights of the four nets; `None` means the shipped ones.
    pub weights: Option<PathBuf>,
    /// Files of labelled balls.
    pub labels: Vec<PathBuf>,
    /// Passes over the scenes.
    pub epochs: usize,
    pub recipe: DynamicsRecipe,
    /// Train without the fold's dev tasks, so that settings can be chosen on them.
    pub without_dev: bool,
    /// Start from the dynamics net in this file instead of random weights.
    pub from: Option<PathBuf>,
    pub run: RunSettings,
}

/// How the dynamics net is trained.
#[derive(Clone, Debug, PartialEq)]
pub struct DynamicsRecipe {
    /// Scenes per batch.
    pub batch: u16,
    pub optimiser: Optimiser,
    /// Peak learning rate.
    pub learning_rate: f64,
    /// Balls per scene in a batch, resampled for each batch.
    pub balls_per_scene: u16,
    /// Balls per scene in a batch whose paths are learned too.
    pub imagined_per_scene: u16,
    /// Weights of these paths in the loss.
    pub path_weights: PathWeights,
}

impl Default for DynamicsRecipe {
    fn default() -> DynamicsRecipe {
        DynamicsRecipe {
            batch: BATCH,
            optimiser: Optimiser::default(),
            learning_rate: LEARNING_RATE,
            balls_per_scene: 256,
            imagined_per_scene: 96,
            path_weights: PathWeights::default(),
        }
    }
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            fold: FoldId::default(),
            weights: None,
            labels: vec![LABELS.into()],
            epochs: 100,
            recipe: DynamicsRecipe::default(),
            without_dev: false,
            from: None,
            run: RunSettings::default(),
        }
    }
}

impl Settings {
    /// Starts or continues training. Returns the weights file of all nets if the run is complete.
    ///
    /// # Errors
    /// If the weights or the labels cannot be used, or the folder cannot be continued or written.
    pub fn train(&self, progress: &mut dyn Progress) -> anyhow::Result<Option<PathBuf>> {
        let DynamicsRecipe { batch, optimiser, learning_rate, balls_per_scene, imagined_per_scene, path_weights } =
            self.recipe;
        ensure!(
            imagined_per_scene <= balls_per_scene,
            "the net cannot learn the paths of {imagined_per_scene} of {balls_per_scene} balls: lower \
             --imagined-per-scene, or raise --balls-per-scene"
        );
        let model = ModelFile::read(self.weights.as_deref(), self.fold)?;
        model.check(AgentName::Paper, self.fold)?;
        let ModelFile { mut nets, mut card, digest, .. } = model;
        let without_dev = self.without_dev || card.without_dev;
        let scenes = LabelledScenes::read(&self.labels, self.fold, without_dev)?;
        let from = self.from.as_deref().map(|path| self.started_from(path, without_dev)).transpose()?;
        let before = from.as_ref().and_then(|from| from.card.dynamics.as_ref());
        let began_with = before.map_or(LearnedFrom::RandomScenes, |card| card.learned_from);
        let (unlisted, random_scenes) = before.map_or((0, 0), |card| (card.unlisted, card.random_scenes));
        card.success = None;
        card.dynamics = Some(DynamicsCard {
            seed: self.run.seed,
            epochs: self.epochs,
            batch,
            balls_per_scene,
            imagined_per_scene,
            optimiser,
            learning_rate,
            path_weights,
            balls: scenes.balls(),
            unlisted: scenes.unlisted().max(unlisted),
            random_scenes: scenes.random().max(random_scenes),
            learned_from: scenes.learned_from().max(began_with),
            without_dev,
            from: from.as_ref().map(|from| from.digest.clone()),
        });
        let folder = self.run.out.clone().unwrap_or_else(|| training_folder(self.fold).join("dynamics"));
        let trainer = match from.and_then(|from| from.nets.dynamics) {
            Some(net) => Trainer::from_nets(net),
            None => Trainer::<DynamicsNet>::new(self.run.seed),
        };
        let trainer = trainer.with_optimiser(optimiser);
        let losses = ["cell", "ball", "from paths", "paths", "errors"];
        let inputs = Inputs::of(&self.labels)?.added_to(digest);
        let mut run = TrainingRun::open(folder, card, inputs, &losses, trainer, progress)?;
        let complete = run.train(
            &scenes.plan(self.epochs, batch, learning_rate),
            &self.run,
            |number| self.batch(&scenes, number),
            |trainer, batch, learning_rate| trainer.step(batch, path_weights, learning_rate),
            progress,
        )?;
        if !complete {
            return Ok(None);
        }
        // Its cell logits replace those of the success net.
        (nets.success, nets.dynamics) = (None, Some(run.trainer.nets()));
        run.write_weights(|card| nets.save(card)).map(Some)
    }

    /// Reads the weights to start from. With `without_dev`, the dynamics net must not have been trained on dev tasks.
    fn started_from(&self, path: &Path, without_dev: bool) -> anyhow::Result<ModelFile> {
        let model = ModelFile::read(Some(path), self.fold)?;
        model.check(AgentName::Dynamics, self.fold)?;
        ensure!(
            !(without_dev && model.card.dynamics.as_ref().is_some_and(DynamicsCard::has_seen_dev)),
            "{} was trained on dev tasks: name weights trained with --without-dev, or train all nets on dev tasks",
            path.display()
        );
        Ok(model)
    }

    /// Makes a batch of the run, by its number.
    fn batch(&self, scenes: &LabelledScenes, number: usize) -> DynamicsBatch {
        let mut batch = DynamicsBatch::default();
        let sampling = Sampling::Uniform(self.recipe.balls_per_scene);
        for Drawn { scene, balls, mirrored } in scenes.draw(self.recipe.batch, self.run.seed, sampling, number) {
            let balls = balls.into_iter().map(|ball| {
                let (placed, solved) = scene.balls[ball];
                (placed, solved, scene.paths(ball))
            });
            let coverage = scene_coverage(&scene.scene);
            let imagined = self.recipe.imagined_per_scene.into();
            let added = batch.add(&coverage, scene.starts, balls, imagined, mirrored);
            added.expect("the balls were checked when they were read");
        }
        batch
    }
}
