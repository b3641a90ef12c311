//! `pathlight judge`: trains the net that judges balls, and puts it into a weights file beside the other four.
//!
//! It learns from the training tasks of the weights' own fold, so that it has seen no other tasks than they. The
//! learning rate rises over the first batches and then falls to nothing. The run lives in a folder (`run`).

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::ensure;
use pathlight::dataset::labels::LabelledBalls;
use pathlight::nets::training::{JudgeBatch, Trainer};
use pathlight::nets::{Judge, JudgeCard, flex};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::TaskId;
use pathlight::raster::{Bitmap, CHANNELS, scene_channels};
use rand::seq::{IndexedRandom, SliceRandom};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::digest;
use super::fold_args::FoldArgs;
use super::label::{Labelled, read_labels};
use super::model_args::ModelArgs;
use super::progress::Progress;
use super::scene_cache::SceneCache;
use super::training_run::TrainingRun;

/// Batches over which the learning rate rises.
const RISE: f64 = 200.0;

/// Train a net that judges balls, and add it to weights
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    which: FoldArgs,

    #[command(flatten)]
    weights: ModelArgs,

    /// Balls with their outcome, from `pathlight label`
    #[arg(long, default_value = "target/labels.jsonl")]
    labels: PathBuf,

    /// Folder of the run: checkpoint, losses.csv, weights.safetensors of all five nets
    /// [default: target/train/SETUP-FOLD/judge]
    #[arg(long)]
    out: Option<PathBuf>,

    /// Passes over the scenes
    #[arg(long, default_value_t = 100)]
    epochs: usize,

    /// Scenes in a batch
    #[arg(long, default_value_t = 32, value_parser = clap::value_parser!(u16).range(1..))]
    batch: u16,

    /// Balls of each scene in a batch, drawn anew each time
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u16).range(1..))]
    balls: u16,

    /// Highest learning rate of Adam
    #[arg(long, default_value_t = 3e-3)]
    rate: f64,

    /// Batches between two checkpoints, and between two lines of losses
    #[arg(long, value_name = "BATCHES", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..))]
    checkpoint: u16,

    /// End this run after so many batches, at a checkpoint; the same command goes on from there
    #[arg(long, value_name = "BATCHES")]
    stop_after: Option<usize>,

    /// Leave the dev tasks out, to choose settings by them
    #[arg(long)]
    without_dev: bool,

    /// Seed of the initial weights and of the order of the scenes
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

/// A scene and the balls that were tried in it.
struct Tried {
    scene: [Bitmap; CHANNELS],
    balls: Vec<(Ball, bool)>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let (mut nets, mut card) = self.weights.load(&self.which)?;
        let fold = self.which.tasks();
        let tasks = if self.without_dev { fold.train } else { fold.all_train() };
        let tried = tried(&self.labels, &tasks, &self.which)?;
        card.judge = Some(JudgeCard {
            seed: self.seed,
            epochs: self.epochs,
            batch: self.batch,
            balls_per_scene: self.balls,
            learning_rate: self.rate,
            balls: tried.iter().map(|tried| tried.balls.len()).sum(),
        });
        let folder = self.out.clone().unwrap_or_else(|| self.which.folder().join("judge"));
        let trainer = Trainer::<Judge>::new(flex(), self.seed);
        let mut run = TrainingRun::open(folder, card, digest(&self.labels)?, &["judge"], trainer)?;
        let batches = tried.len().div_ceil(self.batch.into());
        let total = batches * self.epochs;
        let mut progress = Progress::new(Some(total as u64));
        let mut done = run.done();
        progress.advance(done as u64, format!("batch {done}"));
        let stop = self.stop_after.map_or(usize::MAX, |batches| done + batches);
        let (mut sum, mut summed) = (0.0, 0);
        while done < total {
            let trials = self.draw(&tried, done)?;
            let rise = ((done + 1) as f64 / RISE).min(1.0);
            sum += run.trainer.step(trials, self.rate * rise * (1.0 - done as f64 / total as f64));
            done += 1;
            summed += 1;
            if done.is_multiple_of(self.checkpoint.into()) || done == total {
                let loss = sum / summed as f32;
                run.save((done - 1) / batches, done, &[loss])?;
                progress.advance(summed, format!("batch {done} of {total}, loss {loss:.4}"));
                (sum, summed) = (0.0, 0);
                if done >= stop {
                    break;
                }
            }
        }
        if done < total {
            progress.finish(&format!("batch {done} of {total}: stopped as told"));
            return Ok(());
        }
        nets.judge = Some(run.trainer.nets());
        let weights = run.finish(&nets)?;
        progress.finish(&format!("{total} batches; weights are in {},", weights.display()));
        Ok(())
    }

    /// The scenes and balls of one batch of the run; they follow from the seed and its number alone.
    fn draw(&self, tried: &[Tried], number: usize) -> anyhow::Result<JudgeBatch> {
        let (size, batches) = (usize::from(self.batch), tried.len().div_ceil(self.batch.into()));
        let (epoch, batch) = (number / batches, number % batches);
        let seed = self.seed.wrapping_mul(1_000_000);
        let mut order: Vec<&Tried> = tried.iter().collect();
        order.shuffle(&mut Pcg64Mcg::seed_from_u64(seed.wrapping_add(epoch as u64)));
        let mut rng = Pcg64Mcg::seed_from_u64(!seed.wrapping_add(number as u64));
        let mut trials = JudgeBatch::default();
        for Tried { scene, balls } in order.into_iter().skip(batch * size).take(size) {
            let chosen: Vec<(Ball, bool)> = balls.sample(&mut rng, self.balls.into()).copied().collect();
            trials.add(scene, &chosen, rng.random())?;
        }
        Ok(trials)
    }
}

/// The balls of some tasks, scene by scene.
fn tried(path: &Path, tasks: &[TaskId], fold: &FoldArgs) -> anyhow::Result<Vec<Tried>> {
    let Labelled { lines, training_tasks_of, .. } = read_labels(path)?;
    if let Some((setup, number)) = training_tasks_of {
        ensure!(
            (setup, number) == (fold.setup, fold.fold),
            "{} holds balls of the training tasks of {setup} {number} only: label those of {} {}",
            path.display(),
            fold.setup,
            fold.fold
        );
    }
    let scenes = SceneCache::new();
    let mut tried: BTreeMap<TaskId, Tried> = BTreeMap::new();
    for LabelledBalls { task, solved, failed } in lines {
        if tasks.binary_search(&task).is_err() {
            continue;
        }
        let scene = scenes.get(task)?;
        let entry = tried.entry(task).or_insert_with(|| Tried { scene: scene_channels(scene), balls: Vec::new() });
        entry.balls.extend(solved.into_iter().map(|ball| (ball, true)));
        entry.balls.extend(failed.into_iter().map(|ball| (ball, false)));
    }
    ensure!(!tried.is_empty(), "{} holds no balls of this fold: label all templates", path.display());
    Ok(tried.into_values().collect())
}
