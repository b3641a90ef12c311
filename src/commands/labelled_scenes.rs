//! The labelled balls of a fold's training tasks, by scene, and those of them that make a batch; used by `train-judge` and
//! `train-dynamics`.

use std::collections::btree_map::{BTreeMap, Entry};
use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::benchmark::folds::Setup;
use pathlight::dataset::labels::{LabelledBalls, PATHS_LEN};
use pathlight::dataset::scene_variants::scene_variant;
use pathlight::nets::ball_head::Starts;
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use rand::seq::{SliceRandom, index};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::fold_args::FoldArgs;
use super::label::{Labelled, read_labels};
use super::training_args::TrainingArgs;

/// The scenes of a fold's training tasks with their labelled balls; at least one.
pub struct LabelledScenes(Vec<LabelledScene>);

/// A scene and its labelled balls.
pub struct LabelledScene {
    /// Whether it is a variant of a task's scene.
    variant: bool,
    pub scene: Scene,
    pub starts: Starts,
    /// Each with whether it solves the task.
    pub balls: Vec<(Ball, bool)>,
    /// `PATHS_LEN` bytes for each ball; fewer if balls came without their paths.
    paths: Vec<u8>,
}

/// What a batch takes of a scene.
pub struct Drawn<'a> {
    pub scene: &'a LabelledScene,
    /// Indices of balls.
    pub balls: Vec<usize>,
    /// Whether scene and balls are mirrored left to right.
    pub mirrored: bool,
}

impl LabelledScene {
    /// The paths of a ball, by its index.
    pub fn paths(&self, ball: usize) -> &[u8] {
        &self.paths[ball * PATHS_LEN..][..PATHS_LEN]
    }
}

impl LabelledScenes {
    /// Reads files of `pathlight label`.
    ///
    /// # Errors
    /// If a file cannot be used, may tell of the fold's test tasks, or none has balls of its training tasks.
    pub fn read(files: &[PathBuf], fold: &FoldArgs, without_dev: bool) -> anyhow::Result<LabelledScenes> {
        let tasks = fold.training_tasks(without_dev);
        let mut scenes: BTreeMap<(TaskId, Option<u32>), LabelledScene> = BTreeMap::new();
        for path in files {
            let Labelled { lines, training_tasks_of, proposed, .. } = read_labels(path)?;
            // Balls are sampled around solutions of their own template alone; so across templates, those of any fold tell
            // nothing of the test tasks. A net that proposes balls knows all that it was trained on.
            ensure!(
                !proposed || training_tasks_of.is_some(),
                "{} does not say which fold the net that proposed its balls belongs to: label again with --setup and --fold",
                path.display()
            );
            let of_template_alone = fold.setup == Setup::Cross && !proposed;
            if let Some((setup, number)) = training_tasks_of.filter(|_| !of_template_alone) {
                ensure!(
                    (setup, number) == (fold.setup, fold.fold),
                    "{} holds balls of the training tasks of {setup} {number} only: label those of {} {}",
                    path.display(),
                    fold.setup,
                    fold.fold
                );
            }
            for LabelledBalls { task, variant, solved, failed, paths } in lines {
                if tasks.binary_search(&task).is_err() {
                    continue;
                }
                let entry = match scenes.entry((task, variant)) {
                    Entry::Occupied(entry) => entry.into_mut(),
                    Entry::Vacant(entry) => {
                        let loaded = Task::load(task)?;
                        let varied = variant.map(|number| {
                            let changed =
                                format!("variant {number} of {task} is not made any more: label the variants again");
                            scene_variant(&loaded, number).context(changed)
                        });
                        let scene = varied.transpose()?.unwrap_or(loaded.scene);
                        let starts = Starts::of(&scene);
                        let variant = variant.is_some();
                        entry.insert(LabelledScene { variant, scene, starts, balls: Vec::new(), paths: Vec::new() })
                    }
                };
                entry.paths.extend(paths.0);
                entry.balls.extend(solved.into_iter().map(|ball| (ball, true)));
                entry.balls.extend(failed.into_iter().map(|ball| (ball, false)));
            }
        }
        ensure!(!scenes.is_empty(), "the labels hold no balls of the training tasks of {fold}: label all templates");
        Ok(LabelledScenes(scenes.into_values().collect()))
    }

    /// The number of balls.
    pub fn balls(&self) -> usize {
        self.0.iter().map(|scene| scene.balls.len()).sum()
    }

    /// How many of the scenes are variants of tasks' scenes.
    pub fn variants(&self) -> usize {
        self.0.iter().filter(|scene| scene.variant).count()
    }

    /// Whether every ball has its paths.
    pub fn have_paths(&self) -> bool {
        self.0.iter().all(|scene| scene.paths.len() == scene.balls.len() * PATHS_LEN)
    }

    /// The number of batches that take every scene once.
    pub fn batches_per_epoch(&self, training: &TrainingArgs) -> usize {
        self.0.len().div_ceil(training.batch.into())
    }

    /// Draws a batch of the run; it depends only on the seed and its number.
    pub fn draw(
        &self,
        training: &TrainingArgs,
        balls_per_scene: u16,
        number: usize,
    ) -> impl Iterator<Item = Drawn<'_>> + use<'_> {
        let size = usize::from(training.batch);
        let batches_per_epoch = self.batches_per_epoch(training);
        let (epoch, batch) = (number / batches_per_epoch, number % batches_per_epoch);
        let seed = training.seed.wrapping_mul(1_000_000);
        let mut order: Vec<&LabelledScene> = self.0.iter().collect();
        order.shuffle(&mut Pcg64Mcg::seed_from_u64(seed.wrapping_add(epoch as u64)));
        let mut rng = Pcg64Mcg::seed_from_u64(!seed.wrapping_add(number as u64));
        order.into_iter().skip(batch * size).take(size).map(move |scene| {
            let count = scene.balls.len();
            let balls = index::sample(&mut rng, count, count.min(balls_per_scene.into())).into_vec();
            Drawn { scene, balls, mirrored: rng.random() }
        })
    }
}
