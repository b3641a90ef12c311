//! The labelled balls that a net of a fold may learn from, by scene, and the drawing of batches from them; used to
//! train the success net, the dynamics net and DQN.

use std::collections::btree_map::{BTreeMap, Entry};
use std::path::PathBuf;

use anyhow::{anyhow, ensure};
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::nets::LearnedFrom;
use pathlight::nets::ball_head::Starts;
use pathlight::nets::training::{Schedule, WARMUP_STEPS};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::TaskId;
use rand::seq::{SliceRandom, index};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::training_run::Plan;
use crate::data::label::read_labels;
use crate::data::label_use::{LabelOrigin, may_learn};
use crate::data::labels::{LabelledBalls, PATHS_LEN};
use crate::data::scene_id::SceneId;

/// The scenes that a net of a fold may learn from, with their labelled balls.
pub struct LabelledScenes {
    /// At least one.
    scenes: Vec<LabelledScene>,
    learned_from: LearnedFrom,
}

/// A scene and its labelled balls.
pub struct LabelledScene {
    id: SceneId,
    pub scene: Scene,
    pub starts: Starts,
    /// Each ball, and whether it solves the scene.
    pub balls: Vec<(Ball, bool)>,
    /// `PATHS_LEN` bytes for each ball.
    paths: Vec<u8>,
}

/// How a batch chooses balls of a scene.
#[derive(Clone, Copy)]
pub enum Sampling {
    /// Up to this many different balls.
    Uniform(u16),
    /// This many balls, half of which solve if the scene has both kinds. The same ball may be drawn again.
    Balanced(u16),
}

/// The part of a scene in a batch.
pub struct Drawn<'a> {
    pub scene: &'a LabelledScene,
    /// Indices into the balls of the scene.
    pub balls: Vec<usize>,
    /// Whether scene and balls are mirrored left to right.
    pub mirrored: bool,
}

impl LabelledScene {
    /// Makes the scene, without balls yet.
    fn new(id: SceneId) -> anyhow::Result<LabelledScene> {
        let scene = id.scene()?;
        let starts = Starts::of(&scene);
        Ok(LabelledScene { id, scene, starts, balls: Vec::new(), paths: Vec::new() })
    }

    /// Adds balls, except those that were sampled around a solution of a task outside `tasks`.
    fn add(&mut self, LabelledBalls { solved, failed, siblings, paths, .. }: LabelledBalls, tasks: &[TaskId]) {
        let balls = solved.into_iter().map(|ball| (ball, true)).chain(failed.into_iter().map(|ball| (ball, false)));
        for (index, ball) in balls.enumerate() {
            if siblings[index].is_none_or(|task| tasks.binary_search(&task).is_ok()) {
                self.balls.push(ball);
                self.paths.extend_from_slice(&paths.0[index * PATHS_LEN..][..PATHS_LEN]);
            }
        }
    }

    /// Draws indices of balls.
    fn draw(&self, sampling: Sampling, rng: &mut Pcg64Mcg) -> Vec<usize> {
        match sampling {
            Sampling::Uniform(count) => {
                index::sample(rng, self.balls.len(), self.balls.len().min(count.into())).into_vec()
            }
            Sampling::Balanced(count) => {
                let (solved, failed): (Vec<usize>, Vec<usize>) =
                    (0..self.balls.len()).partition(|&ball| self.balls[ball].1);
                let kinds = [&solved, &failed].into_iter().filter(|kind| !kind.is_empty()).cycle().take(count.into());
                kinds.map(|kind| kind[rng.random_range(0..kind.len())]).collect()
            }
        }
    }

    /// The paths of a ball, by its index.
    pub fn paths(&self, ball: usize) -> &[u8] {
        &self.paths[ball * PATHS_LEN..][..PATHS_LEN]
    }
}

/// Returns the tasks to train on, ascending: PHYRE's training tasks, with or without its dev tasks.
pub fn training_tasks(fold: FoldId, without_dev: bool) -> Vec<TaskId> {
    let tasks = fold.tasks();
    if without_dev { tasks.train } else { tasks.all_train() }
}

/// Whether a net that is trained on these tasks may learn from a scene: one of the tasks, an unlisted task of their
/// templates, or a random scene.
fn trains_on(scene: SceneId, tasks: &[TaskId]) -> bool {
    match scene {
        SceneId::Task(task) => tasks.binary_search(&task).is_ok(),
        SceneId::Unlisted(template, _) => tasks.iter().any(|task| task.template == template),
        SceneId::Random(_) => true,
    }
}

impl LabelledScenes {
    /// Reads files of `data label`. Leaves out unlisted tasks that no ball solves, because the benchmark lists no such
    /// tasks.
    ///
    /// # Errors
    /// If a file cannot be used or may reveal the fold's test tasks, or if no file has balls that the net may learn
    /// from.
    pub fn read(files: &[PathBuf], fold: FoldId, without_dev: bool) -> anyhow::Result<LabelledScenes> {
        let tasks = training_tasks(fold, without_dev);
        let mut scenes: BTreeMap<SceneId, LabelledScene> = BTreeMap::new();
        let mut learned_from = LearnedFrom::RandomScenes;
        for (index, path) in files.iter().enumerate() {
            ensure!(!files[..index].contains(path), "{} is named twice: name each file once", path.display());
            let labelled = read_labels(path)?;
            ensure!(
                labelled.is_complete(),
                "{} ends within a round: finish it with `pathlight-lab data label`",
                path.display()
            );
            let training_tasks_of = labelled.training_tasks_of.map(|(setup, fold)| FoldId { setup, fold });
            let origin = LabelOrigin { training_tasks_of, proposer: labelled.proposer };
            may_learn(origin, fold, without_dev).map_err(|why| anyhow!("{} {why}", path.display()))?;
            learned_from = learned_from.max(origin.proposer.map_or(learned_from, |proposer| proposer.learned_from));
            for line in labelled.lines {
                if trains_on(line.scene, &tasks) && line.count() > 0 {
                    let scene = match scenes.entry(line.scene) {
                        Entry::Occupied(entry) => entry.into_mut(),
                        Entry::Vacant(entry) => entry.insert(LabelledScene::new(line.scene)?),
                    };
                    scene.add(line, &tasks);
                }
            }
        }
        let is_solved = |scene: &LabelledScene| scene.balls.iter().any(|&(_, solves)| solves);
        scenes.retain(|id, scene| !matches!(id, SceneId::Unlisted(..)) || is_solved(scene));
        ensure!(
            !scenes.is_empty(),
            "the labels hold no balls of the training tasks of {fold}: label all templates in at least one round"
        );
        let of_scenes = scenes.keys().map(|scene| match scene {
            SceneId::Random(_) => LearnedFrom::RandomScenes,
            // Across templates, a fold has unlisted tasks of its own.
            SceneId::Unlisted(..) if fold.setup == Setup::Within => LearnedFrom::UnlistedTasks,
            SceneId::Unlisted(..) | SceneId::Task(_) => LearnedFrom::Tasks,
        });
        let learned_from = of_scenes.fold(learned_from, Ord::max);
        Ok(LabelledScenes { scenes: scenes.into_values().collect(), learned_from })
    }

    /// Returns the scenes, for a net whose card does not count unlisted tasks and random scenes.
    ///
    /// # Errors
    /// If the labels hold unlisted tasks or random scenes.
    pub fn of_tasks(self) -> anyhow::Result<LabelledScenes> {
        let only_dynamics = "only the dynamics net learns from those";
        ensure!(self.random() == 0, "the labels hold balls in random scenes: {only_dynamics}");
        ensure!(self.unlisted() == 0, "the labels hold balls in unlisted tasks: {only_dynamics}");
        Ok(self)
    }

    /// The number of balls.
    pub fn balls(&self) -> usize {
        self.scenes.iter().map(|scene| scene.balls.len()).sum()
    }

    /// The number of scenes that are unlisted tasks.
    pub fn unlisted(&self) -> usize {
        self.scenes.iter().filter(|scene| matches!(scene.id, SceneId::Unlisted(..))).count()
    }

    /// The number of random scenes.
    pub fn random(&self) -> usize {
        self.scenes.iter().filter(|scene| matches!(scene.id, SceneId::Random(_))).count()
    }

    /// What a net that learns from them has learned from, including the nets that proposed the balls.
    pub fn learned_from(&self) -> LearnedFrom {
        self.learned_from
    }

    /// The number of batches that cover every scene once.
    fn batches_per_epoch(&self, batch: u16) -> usize {
        self.scenes.len().div_ceil(batch.into())
    }

    /// The plan of a run on these scenes: the learning rate rises to its peak, and decays linearly to zero.
    pub fn plan(&self, epochs: usize, batch: u16, learning_rate: f64) -> Plan {
        let schedule = Schedule::WarmupLinear { peak: learning_rate, warmup_steps: WARMUP_STEPS };
        Plan { epochs, batches_per_epoch: self.batches_per_epoch(batch), schedule }
    }

    /// Draws a batch of this many scenes, which depends only on the seed of the run and the number of the batch.
    pub fn draw(
        &self,
        batch: u16,
        seed: u64,
        sampling: Sampling,
        number: usize,
    ) -> impl Iterator<Item = Drawn<'_>> + use<'_> {
        let batches_per_epoch = self.batches_per_epoch(batch);
        let (epoch, place) = (number / batches_per_epoch, number % batches_per_epoch);
        let seed = seed.wrapping_mul(1_000_000);
        let mut order: Vec<&LabelledScene> = self.scenes.iter().collect();
        order.shuffle(&mut Pcg64Mcg::seed_from_u64(seed.wrapping_add(epoch as u64)));
        let mut rng = Pcg64Mcg::seed_from_u64(!seed.wrapping_add(number as u64));
        let size = usize::from(batch);
        order.into_iter().skip(place * size).take(size).map(move |scene| {
            let balls = scene.draw(sampling, &mut rng);
            Drawn { scene, balls, mirrored: rng.random() }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_net_learns_from_no_unlisted_task_of_a_template_that_it_is_tested_on() {
        for fold in 0..10 {
            let fold = FoldId { setup: Setup::Cross, fold };
            for (without_dev, held_out) in [(false, 5), (true, 9)] {
                let tasks = training_tasks(fold, without_dev);
                let learns = |template: &usize| trains_on(SceneId::Unlisted(*template, 0), &tasks);
                let kept: Vec<usize> = (0..25).filter(|template| !learns(template)).collect();
                assert_eq!(kept.len(), held_out, "{fold}");
                let tests = fold.tasks().test;
                assert!(tests.iter().all(|task| kept.contains(&task.template)), "{fold}");
            }
        }
    }

    #[test]
    fn half_of_a_balanced_draw_solves() {
        let id = SceneId::Task("00002:007".parse().expect("an id"));
        let scene = id.scene().expect("a scene");
        let ball = Ball { x: 100.0, y: 100.0, r: 5.0 };
        let starts = Starts::of(&scene);
        let scene = |balls| LabelledScene { id, scene: scene.clone(), starts, balls, paths: Vec::new() };
        let mixed = scene((0..30).map(|index| (ball, index == 7)).collect());
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        let drawn = mixed.draw(Sampling::Balanced(10), &mut rng);
        assert_eq!(drawn.iter().filter(|&&index| index == 7).count(), 5);
        assert_eq!(drawn.len(), 10);
        let failed = scene(vec![(ball, false); 3]);
        assert_eq!(failed.draw(Sampling::Balanced(10), &mut rng).len(), 10, "of one kind, all are of that kind");
        let mut all = failed.draw(Sampling::Uniform(10), &mut rng);
        all.sort_unstable();
        assert_eq!(all, [0, 1, 2], "a uniform draw takes no ball twice");
    }
}
