//! `pathlight train-judge`: trains the net that judges balls, and adds it to the weights of the four nets.
//!
//! It learns from labelled balls of the tasks that the four nets were trained on, so that the weights as a whole have
//! seen no other tasks. `training_run` keeps the run in a folder.

use std::path::PathBuf;
use std::slice;

use pathlight::nets::training::{JudgeBatch, Trainer};
use pathlight::nets::{Judge, JudgeCard};
use pathlight::raster::scene_coverage;

use super::digest;
use super::fold_args::FoldArgs;
use super::labelled_scenes::{Drawn, LabelledScenes, Sampling};
use super::model_args::ModelArgs;
use super::progress::say;
use super::training_args::{TrainingArgs, epochs};
use super::training_run::TrainingRun;

/// Train the net that judges balls, and add it to the weights of the four nets, in place of a dynamics net
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub fold: FoldArgs,

    #[command(flatten)]
    pub model: ModelArgs,

    /// Balls with their outcome, from `pathlight label`
    #[arg(long, default_value = "target/labels.jsonl")]
    pub labels: PathBuf,

    /// Passes over the scenes
    #[arg(long, default_value_t = 100, value_parser = epochs())]
    pub epochs: usize,

    /// Balls of each scene in a batch, sampled anew each time
    #[arg(long, value_name = "N", default_value_t = 256, value_parser = clap::value_parser!(u16).range(1..))]
    pub balls_per_scene: u16,

    #[command(flatten)]
    pub training: TrainingArgs,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let (mut nets, mut card) = self.model.load(&self.fold)?;
        let scenes = LabelledScenes::read(slice::from_ref(&self.labels), &self.fold, card.without_dev)?;
        card.dynamics = None;
        card.judge = Some(JudgeCard {
            seed: self.training.seed,
            epochs: self.epochs,
            batch: self.training.batch,
            balls_per_scene: self.balls_per_scene,
            learning_rate: self.training.learning_rate,
            balls: scenes.balls(),
        });
        let folder = self.training.out.clone().unwrap_or_else(|| self.fold.folder().join("judge"));
        let trainer = Trainer::<Judge>::new(self.training.seed);
        let mut run = TrainingRun::open(folder, card, digest(&self.labels)?, &["judge"], trainer)?;
        let plan = scenes.plan(self.epochs, &self.training);
        let complete = run.train(
            &plan,
            &self.training,
            |number| self.batch(&scenes, number),
            |trainer, batch, learning_rate| vec![trainer.step(batch, learning_rate)],
        )?;
        if complete {
            // Agents would prefer a dynamics net.
            (nets.judge, nets.dynamics) = (Some(run.trainer.nets()), None);
            say(&format!(
                "the weights of all five nets are in {}",
                run.write_weights(|card| nets.save(card))?.display()
            ));
        }
        Ok(())
    }

    /// A batch of the run, by its number.
    fn batch(&self, scenes: &LabelledScenes, number: usize) -> JudgeBatch {
        let mut batch = JudgeBatch::default();
        for Drawn { scene, balls, mirrored } in
            scenes.draw(&self.training, Sampling::Uniform(self.balls_per_scene), number)
        {
            let balls = balls.into_iter().map(|ball| scene.balls[ball]);
            let added = batch.add(&scene_coverage(&scene.scene), balls, mirrored);
            added.expect("the balls were checked when they were read");
        }
        batch
    }
}
