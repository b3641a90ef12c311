//! `pathlight train-dynamics`: trains the net that imagines what balls lead to, and adds it to the weights of the four
//! nets, where it takes the place of a judge.
//!
//! It learns from labelled balls of the tasks that the four nets were trained on, so that the weights as a whole have
//! seen no other tasks. It starts from the judge of these weights, if they have one: the U-Net of both is the same.
//! `training_run` keeps the run in a folder.

use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::nets::training::{DynamicsBatch, Trainer};
use pathlight::nets::{DynamicsCard, DynamicsNet};
use pathlight::raster::scene_coverage;

use super::digest;
use super::fold_args::FoldArgs;
use super::labelled_scenes::{Drawn, LabelledScenes, Sampling};
use super::model_args::ModelArgs;
use super::progress::say;
use super::training_args::{TrainingArgs, epochs};
use super::training_run::TrainingRun;

/// Train the net that imagines what balls lead to, and add it to the weights of the four nets; it starts from their
/// judge, if they have one
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub fold: FoldArgs,

    #[command(flatten)]
    pub model: ModelArgs,

    /// Balls with their outcomes and paths, from `pathlight label`; can be repeated
    #[arg(long, default_value = "target/labels.jsonl")]
    pub labels: Vec<PathBuf>,

    /// Passes over the scenes
    #[arg(long, default_value_t = 100, value_parser = epochs())]
    pub epochs: usize,

    /// Balls of each scene in a batch, sampled anew each time
    #[arg(long, value_name = "N", default_value_t = 256, value_parser = clap::value_parser!(u16).range(1..))]
    pub balls_per_scene: u16,

    /// Of these, balls whose paths are learned
    #[arg(long, value_name = "N", default_value_t = 96, value_parser = clap::value_parser!(u16).range(1..))]
    pub imagined_per_scene: u16,

    /// Leave the fold's dev tasks out, so that settings may be chosen on them
    #[arg(long)]
    pub without_dev: bool,

    /// Learn chances alone, not the paths, to measure what these bring; such weights cannot be published
    #[arg(long)]
    pub without_paths: bool,

    /// Start from the dynamics net of these weights instead
    #[arg(long, value_name = "FILE")]
    pub from: Option<PathBuf>,

    #[command(flatten)]
    pub training: TrainingArgs,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let (mut nets, mut card) = self.model.load(&self.fold)?;
        let without_dev = self.without_dev || card.without_dev;
        ensure!(
            card.without_dev || !self.without_dev || self.from.is_some() || nets.judge.is_none(),
            "the judge that the dynamics net would start from was trained on dev tasks: name the weights of `pathlight train`, \
             or train these with --without-dev too"
        );
        let scenes = LabelledScenes::read(&self.labels, &self.fold, without_dev)?;
        ensure!(scenes.have_paths(), "the labels hold balls without their paths: label them again");
        let judge = if self.from.is_none() { nets.judge.take().zip(card.judge.take()) } else { None };
        card.judge = None;
        card.dynamics = Some(DynamicsCard {
            seed: self.training.seed,
            epochs: self.epochs,
            batch: self.training.batch,
            balls_per_scene: self.balls_per_scene,
            imagined_per_scene: self.imagined_per_scene,
            learning_rate: self.training.learning_rate,
            balls: scenes.balls(),
            coverage: true,
            variants: scenes.variants(),
            without_dev,
            without_paths: self.without_paths,
            from: self.from.as_deref().map(digest).transpose()?,
            judge: judge.as_ref().map(|(_, card)| card.clone()),
        });
        let folder = self.training.out.clone().unwrap_or_else(|| self.fold.folder().join("dynamics"));
        let trainer = match (&self.from, judge) {
            (Some(path), _) => Trainer::from_nets(self.dynamics_of(path, without_dev)?),
            (None, Some((judge, _))) => Trainer::from_judge(judge, self.training.seed),
            (None, None) => Trainer::<DynamicsNet>::new(self.training.seed),
        };
        let losses = ["cell", "ball", "from paths", "paths", "errors"];
        let digests = self.labels.iter().map(|path| digest(path)).collect::<anyhow::Result<Vec<_>>>()?;
        let mut run = TrainingRun::open(folder, card, digests.join(" "), &losses, trainer)?;
        let plan = scenes.plan(self.epochs, &self.training);
        let complete = run.train(
            &plan,
            &self.training,
            |number| self.batch(&scenes, number),
            |trainer, batch, learning_rate| trainer.step(batch, !self.without_paths, learning_rate),
        )?;
        if complete {
            // Its own logits of the cells take the place of the judge's.
            (nets.judge, nets.dynamics) = (None, Some(run.trainer.nets()));
            say(&format!("the weights of all nets are in {}", run.write_weights(|card| nets.save(card))?.display()));
        }
        Ok(())
    }

    /// The dynamics net of a weights file of this fold; `without_dev`: it must not have learned from the dev tasks.
    fn dynamics_of(&self, path: &Path, without_dev: bool) -> anyhow::Result<DynamicsNet> {
        let name = path.display();
        let (nets, card) = ModelArgs { weights: Some(path.to_path_buf()) }.load(&self.fold)?;
        let trained = nets.dynamics.zip(card.dynamics);
        let (net, trained) = trained
            .with_context(|| format!("{name} has no dynamics net: name weights of `pathlight train-dynamics`"))?;
        ensure!(
            trained.without_dev || !without_dev,
            "{name} was trained on dev tasks: name weights that were trained with --without-dev, or train all nets on dev tasks"
        );
        Ok(net)
    }

    /// A batch of the run, by its number.
    fn batch(&self, scenes: &LabelledScenes, number: usize) -> DynamicsBatch {
        let mut batch = DynamicsBatch::default();
        for Drawn { scene, balls, mirrored } in
            scenes.draw(&self.training, Sampling::Uniform(self.balls_per_scene), number)
        {
            let balls = balls.into_iter().map(|ball| {
                let (placed, solved) = scene.balls[ball];
                (placed, solved, scene.paths(ball))
            });
            let added =
                batch.add(&scene_coverage(&scene.scene), scene.starts, balls, self.imagined_per_scene.into(), mirrored);
            added.expect("the balls were checked when they were read");
        }
        batch
    }
}
