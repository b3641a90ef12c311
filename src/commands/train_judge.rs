//! `pathlight train-judge`: trains the net that judges balls, and adds it to the weights of the four nets.
//!
//! It learns from labelled balls of the tasks that the four nets were trained on, so that the weights as a whole have
//! seen no other tasks. `training_run` keeps the run in a folder.

use std::collections::btree_map::{BTreeMap, Entry};
use std::path::{Path, PathBuf};

use anyhow::ensure;
use pathlight::dataset::labels::LabelledBalls;
use pathlight::nets::training::{JudgeBatch, Schedule, Trainer, WARMUP_STEPS};
use pathlight::nets::{Judge, JudgeCard, flex};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::raster::{Bitmap, CHANNELS, scene_channels};
use rand::seq::{IndexedRandom, SliceRandom};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::digest;
use super::fold_args::FoldArgs;
use super::label::{Labelled, read_labels};
use super::model_args::ModelArgs;
use super::progress::say;
use super::training_args::TrainingArgs;
use super::training_run::{Plan, TrainingRun};

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
    #[arg(long, default_value_t = 100)]
    pub epochs: usize,

    /// Balls of each scene in a batch, sampled anew each time
    #[arg(long, value_name = "N", default_value_t = 256, value_parser = clap::value_parser!(u16).range(1..))]
    pub balls_per_scene: u16,

    #[command(flatten)]
    pub training: TrainingArgs,
}

/// A scene and its labelled balls.
struct LabelledScene {
    scene: [Bitmap; CHANNELS],
    /// Each with whether it solves the task.
    balls: Vec<(Ball, bool)>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let (mut nets, mut card) = self.model.load(&self.fold)?;
        let scenes = labelled_scenes(&self.labels, &self.fold, card.without_dev)?;
        card.dynamics = None;
        card.judge = Some(JudgeCard {
            seed: self.training.seed,
            epochs: self.epochs,
            batch: self.training.batch,
            balls_per_scene: self.balls_per_scene,
            learning_rate: self.training.learning_rate,
            balls: scenes.iter().map(|scene| scene.balls.len()).sum(),
        });
        let folder = self.training.out.clone().unwrap_or_else(|| self.fold.folder().join("judge"));
        let trainer = Trainer::<Judge>::new(flex(), self.training.seed);
        let mut run = TrainingRun::open(folder, card, digest(&self.labels)?, &["judge"], trainer)?;
        let schedule = Schedule::WarmupLinear { peak: self.training.learning_rate, warmup_steps: WARMUP_STEPS };
        let batches_per_epoch = scenes.len().div_ceil(self.training.batch.into());
        let plan = Plan { epochs: self.epochs, batches_per_epoch, schedule };
        let complete = run.train(
            &plan,
            &self.training,
            |number| self.batch(&scenes, number),
            |trainer, batch, learning_rate| vec![trainer.step(batch, learning_rate)],
        )?;
        if complete {
            // Agents would prefer a dynamics net.
            (nets.judge, nets.dynamics) = (Some(run.trainer.nets()), None);
            say(&format!("the weights of all five nets are in {}", run.write_weights(&nets)?.display()));
        }
        Ok(())
    }

    /// A batch of the run; it depends only on the seed and its number.
    fn batch(&self, scenes: &[LabelledScene], number: usize) -> JudgeBatch {
        let size = usize::from(self.training.batch);
        let batches_per_epoch = scenes.len().div_ceil(size);
        let (epoch, batch) = (number / batches_per_epoch, number % batches_per_epoch);
        let seed = self.training.seed.wrapping_mul(1_000_000);
        let mut order: Vec<&LabelledScene> = scenes.iter().collect();
        order.shuffle(&mut Pcg64Mcg::seed_from_u64(seed.wrapping_add(epoch as u64)));
        let mut rng = Pcg64Mcg::seed_from_u64(!seed.wrapping_add(number as u64));
        let mut judge_batch = JudgeBatch::default();
        for LabelledScene { scene, balls } in order.into_iter().skip(batch * size).take(size) {
            let chosen: Vec<(Ball, bool)> = balls.sample(&mut rng, self.balls_per_scene.into()).copied().collect();
            judge_batch.add(scene, &chosen, rng.random()).expect("the balls were checked when they were read");
        }
        judge_batch
    }
}

/// The labelled balls of the fold's training tasks, by scene.
fn labelled_scenes(path: &Path, fold: &FoldArgs, without_dev: bool) -> anyhow::Result<Vec<LabelledScene>> {
    let tasks = fold.training_tasks(without_dev);
    let Labelled { lines, training_tasks_of, .. } = read_labels(path)?;
    let name = path.display();
    if let Some((setup, number)) = training_tasks_of {
        ensure!(
            (setup, number) == (fold.setup, fold.fold),
            "{name} holds balls of the training tasks of {setup} {number} only: label those of {} {}",
            fold.setup,
            fold.fold
        );
    }
    let mut scenes: BTreeMap<TaskId, LabelledScene> = BTreeMap::new();
    for LabelledBalls { task, solved, failed, .. } in lines {
        if tasks.binary_search(&task).is_err() {
            continue;
        }
        let entry = match scenes.entry(task) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => {
                let scene = scene_channels(&Task::load(task)?.scene);
                entry.insert(LabelledScene { scene, balls: Vec::new() })
            }
        };
        entry.balls.extend(solved.into_iter().map(|ball| (ball, true)));
        entry.balls.extend(failed.into_iter().map(|ball| (ball, false)));
    }
    ensure!(!scenes.is_empty(), "{name} holds no balls of the training tasks of {fold}: label all templates");
    Ok(scenes.into_values().collect())
}
