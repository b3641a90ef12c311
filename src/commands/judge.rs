//! `pathlight judge`: trains the net that judges balls, and puts it into a weights file beside the other four.
//!
//! It learns from the training tasks of the weights' own fold, so that it has seen no other tasks than they. The
//! learning rate rises over the first steps and then falls to nothing.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::action::Ball;
use pathlight::labels::Labels;
use pathlight::pathnet::trainer::{Trainer, Trials};
use pathlight::pathnet::{Judge, JudgeCard, device};
use pathlight::raster::{Bitmap, CHANNELS, scene_channels};
use pathlight::task::TaskId;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::label::read_labels;
use super::progress::Progress;
use super::scenes::Scenes;
use super::weights::Weights;
use super::which::Which;

/// Steps over which the learning rate rises.
const RISE: f64 = 200.0;

/// Steps between two words on how it goes.
const INTERVAL: usize = 20;

/// Train a net that judges balls, and add it to weights
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    which: Which,

    #[command(flatten)]
    weights: Weights,

    /// Balls with their outcome, from `pathlight label`
    #[arg(long, default_value = "target/labels.jsonl")]
    labels: PathBuf,

    /// Weights file to write, all five nets [default: target/train/SETUP-FOLD/judged.safetensors]
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
        let mut tried = tried(&self.labels, &tasks)?;
        let balls = tried.iter().map(|tried| tried.balls.len()).sum();
        let device = device("flex").map_err(anyhow::Error::msg)?;
        let mut trainer = Trainer::<Judge>::new(device, self.seed);
        let total = tried.len().div_ceil(self.batch.into()) * self.epochs;
        let mut progress = Progress::new(Some(total as u64));
        let mut rng = Pcg64Mcg::seed_from_u64(self.seed);
        let (mut done, mut sum) = (0, 0.0);
        for epoch in 1..=self.epochs {
            tried.shuffle(&mut rng);
            for scenes in tried.chunks_mut(self.batch.into()) {
                let mut trials = Trials::default();
                for Tried { scene, balls } in scenes {
                    let (chosen, _) = balls.partial_shuffle(&mut rng, self.balls.into());
                    trials.add(scene, chosen, rng.random());
                }
                let rise = ((done + 1) as f64 / RISE).min(1.0);
                sum += trainer.step(trials, self.rate * rise * (1.0 - done as f64 / total as f64));
                done += 1;
                if done % INTERVAL == 0 {
                    let loss = sum / INTERVAL as f32;
                    progress.advance(INTERVAL as u64, format!("epoch {epoch}, step {done} of {total}, loss {loss:.4}"));
                    sum = 0.0;
                }
            }
        }
        nets.judge = Some(trainer.nets());
        card.judge = Some(JudgeCard { seed: self.seed, epochs: self.epochs, rate: self.rate, balls });
        let name = format!("target/train/{}-{}/judged.safetensors", self.which.setup, self.which.fold);
        let out = self.out.unwrap_or_else(|| name.into());
        if let Some(folder) = out.parent() {
            fs::create_dir_all(folder).with_context(|| format!("cannot make the folder of {}", out.display()))?;
        }
        fs::write(&out, nets.save(&card)).with_context(|| format!("cannot write {}", out.display()))?;
        progress.finish(&format!("{balls} balls, {total} steps; weights are in {},", out.display()));
        Ok(())
    }
}

/// The balls of some tasks, scene by scene.
fn tried(path: &Path, tasks: &[TaskId]) -> anyhow::Result<Vec<Tried>> {
    let scenes = Scenes::new();
    let mut tried: BTreeMap<TaskId, Tried> = BTreeMap::new();
    for Labels { task, solved, failed } in read_labels(path)? {
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
