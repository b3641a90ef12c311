//! `pathlight train-dynamics`: trains the net that imagines what balls lead to, and adds it to the weights of the four nets,
//! where it takes the place of a judge.
//!
//! It learns from labelled balls of the tasks that the four nets were trained on, so that the weights as a whole have
//! seen no other tasks. `training_run` keeps the run in a folder.

use std::collections::btree_map::{BTreeMap, Entry};
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::benchmark::folds::Setup;
use pathlight::dataset::labels::{LabelledBalls, PATHS_LEN};
use pathlight::nets::ball_head::Starts;
use pathlight::nets::training::{DynamicsBatch, Schedule, Trainer, WARMUP_STEPS};
use pathlight::nets::{DynamicsCard, DynamicsNet, flex};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::raster::{Bitmap, CHANNELS, scene_channels};
use rand::seq::{SliceRandom, index};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::digest;
use super::fold_args::FoldArgs;
use super::label::{Labelled, read_labels};
use super::model_args::ModelArgs;
use super::progress::say;
use super::training_args::TrainingArgs;
use super::training_run::{Plan, TrainingRun};

/// Train the net that imagines what balls lead to, and add it to the weights of the four nets
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
    #[arg(long, default_value_t = 100)]
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

    /// Start from the dynamics net of these weights
    #[arg(long, value_name = "FILE")]
    pub from: Option<PathBuf>,

    #[command(flatten)]
    pub training: TrainingArgs,
}

/// A scene and its labelled balls.
struct LabelledScene {
    scene: [Bitmap; CHANNELS],
    starts: Starts,
    /// Each with whether it solves the task.
    balls: Vec<(Ball, bool)>,
    /// `PATHS_LEN` bytes for each ball.
    paths: Vec<u8>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let (mut nets, mut card) = self.model.load(&self.fold)?;
        let scenes = labelled_scenes(&self.labels, &self.fold, self.without_dev || card.without_dev)?;
        card.judge = None;
        card.dynamics = Some(DynamicsCard {
            seed: self.training.seed,
            epochs: self.epochs,
            batch: self.training.batch,
            balls_per_scene: self.balls_per_scene,
            imagined_per_scene: self.imagined_per_scene,
            learning_rate: self.training.learning_rate,
            balls: scenes.iter().map(|scene| scene.balls.len()).sum(),
            without_dev: self.without_dev || card.without_dev,
            from: self.from.as_deref().map(digest).transpose()?,
        });
        let folder = self.training.out.clone().unwrap_or_else(|| self.fold.folder().join("dynamics"));
        let trainer = match &self.from {
            Some(path) => Trainer::from_nets(self.dynamics_of(path)?, flex()),
            None => Trainer::<DynamicsNet>::new(flex(), self.training.seed),
        };
        let losses = ["cell", "ball", "from paths", "paths", "errors"];
        let mut run = TrainingRun::open(
            folder,
            card,
            self.labels.iter().map(|path| digest(path)).collect::<anyhow::Result<Vec<_>>>()?.join(" "),
            &losses,
            trainer,
        )?;
        let schedule = Schedule::WarmupLinear { peak: self.training.learning_rate, warmup_steps: WARMUP_STEPS };
        let batches_per_epoch = scenes.len().div_ceil(self.training.batch.into());
        let plan = Plan { epochs: self.epochs, batches_per_epoch, schedule };
        let complete = run.train(
            &plan,
            &self.training,
            |number| self.batch(&scenes, number),
            |trainer, batch, learning_rate| trainer.step(batch, learning_rate),
        )?;
        if complete {
            // Its own logits of the cells take the place of the judge's.
            (nets.judge, nets.dynamics) = (None, Some(run.trainer.nets()));
            say(&format!("the weights of all nets are in {}", run.write_weights(&nets)?.display()));
        }
        Ok(())
    }

    /// The dynamics net of a weights file of this fold.
    fn dynamics_of(&self, path: &Path) -> anyhow::Result<DynamicsNet> {
        let name = path.display();
        let (nets, card) = ModelArgs { weights: Some(path.to_path_buf()) }.load(&self.fold)?;
        let trained = nets.dynamics.zip(card.dynamics);
        let (net, trained) = trained
            .with_context(|| format!("{name} has no dynamics net: name weights of `pathlight train-dynamics`"))?;
        ensure!(
            trained.without_dev || !self.without_dev,
            "{name} was trained on dev tasks: leave --without-dev out, or name weights that were trained with it"
        );
        Ok(net)
    }

    /// A batch of the run; it depends only on the seed and its number.
    fn batch(&self, scenes: &[LabelledScene], number: usize) -> DynamicsBatch {
        let size = usize::from(self.training.batch);
        let batches_per_epoch = scenes.len().div_ceil(size);
        let (epoch, batch) = (number / batches_per_epoch, number % batches_per_epoch);
        let seed = self.training.seed.wrapping_mul(1_000_000);
        let mut order: Vec<&LabelledScene> = scenes.iter().collect();
        order.shuffle(&mut Pcg64Mcg::seed_from_u64(seed.wrapping_add(epoch as u64)));
        let mut rng = Pcg64Mcg::seed_from_u64(!seed.wrapping_add(number as u64));
        let mut dynamics_batch = DynamicsBatch::default();
        for LabelledScene { scene, starts, balls, paths } in order.into_iter().skip(batch * size).take(size) {
            let chosen = index::sample(&mut rng, balls.len(), balls.len().min(self.balls_per_scene.into()));
            let chosen = chosen.into_iter().map(|index| {
                let (ball, solved) = balls[index];
                (ball, solved, &paths[index * PATHS_LEN..][..PATHS_LEN])
            });
            let added = dynamics_batch.add(scene, *starts, chosen, self.imagined_per_scene.into(), rng.random());
            added.expect("the balls were checked when they were read");
        }
        dynamics_batch
    }
}

/// The labelled balls of the fold's training tasks, by scene.
fn labelled_scenes(files: &[PathBuf], fold: &FoldArgs, without_dev: bool) -> anyhow::Result<Vec<LabelledScene>> {
    let tasks = fold.training_tasks(without_dev);
    let mut scenes: BTreeMap<TaskId, LabelledScene> = BTreeMap::new();
    for path in files {
        let Labelled { lines, training_tasks_of, .. } = read_labels(path)?;
        let name = path.display();
        // Balls of a template are sampled around solutions of its tasks alone, so across templates every file will do.
        if let (Some((setup, number)), Setup::Within) = (training_tasks_of, fold.setup) {
            ensure!(
                (setup, number) == (fold.setup, fold.fold),
                "{name} holds balls of the training tasks of {setup} {number} only: label those of {} {}",
                fold.setup,
                fold.fold
            );
        }
        for LabelledBalls { task, solved, failed, paths } in lines {
            if tasks.binary_search(&task).is_err() {
                continue;
            }
            let entry = match scenes.entry(task) {
                Entry::Occupied(entry) => entry.into_mut(),
                Entry::Vacant(entry) => {
                    let scene = Task::load(task)?.scene;
                    let (starts, scene) = (Starts::of(&scene), scene_channels(&scene));
                    entry.insert(LabelledScene { scene, starts, balls: Vec::new(), paths: Vec::new() })
                }
            };
            ensure!(
                paths.0.len() == (solved.len() + failed.len()) * PATHS_LEN,
                "{name} holds balls without their paths: label them again"
            );
            entry.paths.extend(paths.0);
            entry.balls.extend(solved.into_iter().map(|ball| (ball, true)));
            entry.balls.extend(failed.into_iter().map(|ball| (ball, false)));
        }
    }
    ensure!(!scenes.is_empty(), "the labels hold no balls of the training tasks of {fold}: label all templates");
    Ok(scenes.into_values().collect())
}
