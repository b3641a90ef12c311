//! `pathlight train-dqn`: trains DQN, the benchmark's baseline, on labelled balls, into a weights file of its own.
//!
//! As published (Bakhtin et al. 2019): binary cross-entropy on batches of which half are solutions. Here they are
//! balanced in each scene, many balls share one reading of it, and scenes are mirrored. `training_run` keeps the run in
//! a folder.

use std::path::PathBuf;

use pathlight::nets::training::{DqnBatch, Trainer};
use pathlight::nets::{Dqn, DqnCard};
use pathlight::raster::scene_coverage;

use super::digest;
use super::fold_args::FoldArgs;
use super::labelled_scenes::{Drawn, LabelledScenes, Sampling};
use super::progress::say;
use super::training_args::{TrainingArgs, epochs};
use super::training_run::TrainingRun;

/// Train DQN, the benchmark's baseline: a net that says how likely an action solves a scene
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub fold: FoldArgs,

    /// Balls with their outcome, from `pathlight label`; can be repeated
    #[arg(long, default_value = "target/labels.jsonl")]
    pub labels: Vec<PathBuf>,

    /// Passes over the scenes
    #[arg(long, default_value_t = 15, value_parser = epochs())]
    pub epochs: usize,

    /// Balls of each scene in a batch, half of them solutions, sampled anew each time
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u16).range(1..))]
    pub balls_per_scene: u16,

    /// Leave the fold's dev tasks out, so that settings may be chosen on them
    #[arg(long)]
    pub without_dev: bool,

    #[command(flatten)]
    pub training: TrainingArgs,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let scenes = LabelledScenes::read(&self.labels, &self.fold, self.without_dev)?;
        let card = DqnCard {
            setup: self.fold.setup,
            fold: self.fold.fold,
            seed: self.training.seed,
            epochs: self.epochs,
            batch: self.training.batch,
            balls_per_scene: self.balls_per_scene,
            learning_rate: self.training.learning_rate,
            balls: scenes.balls(),
            variants: scenes.variants(),
            without_dev: self.without_dev,
        };
        let folder = self.training.out.clone().unwrap_or_else(|| self.fold.folder().join("dqn"));
        let digests = self.labels.iter().map(|path| digest(path)).collect::<anyhow::Result<Vec<_>>>()?;
        let trainer = Trainer::<Dqn>::new(self.training.seed);
        let mut run = TrainingRun::open(folder, card, digests.join(" "), &["dqn"], trainer)?;
        let plan = scenes.plan(self.epochs, &self.training);
        let complete = run.train(
            &plan,
            &self.training,
            |number| self.batch(&scenes, number),
            |trainer, batch, learning_rate| vec![trainer.step(batch, learning_rate)],
        )?;
        if complete {
            let weights = run.write_weights(|card| run.trainer.nets().save(card))?;
            say(&format!("the weights are in {}", weights.display()));
        }
        Ok(())
    }

    /// A batch of the run, by its number.
    fn batch(&self, scenes: &LabelledScenes, number: usize) -> DqnBatch {
        let mut batch = DqnBatch::default();
        let sampling = Sampling::Balanced(self.balls_per_scene);
        for Drawn { scene, balls, mirrored } in scenes.draw(&self.training, sampling, number) {
            let balls = balls.into_iter().map(|ball| scene.balls[ball]);
            batch.add(&scene_coverage(&scene.scene), balls, mirrored);
        }
        batch
    }
}
