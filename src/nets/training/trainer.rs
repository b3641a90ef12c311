//! One optimiser step per batch: the four nets jointly, the success net, the dynamics net or DQN.
//!
//! The loss of the four nets is the sum of the per-pixel binary cross-entropies of their maps, with gradients through
//! the whole chain (Harter et al. 2020). The success net's is the mean binary cross-entropy of the balls. A trainer can
//! be saved between two batches and resumed with the same result. Used by the lab; native only. The learning rate of
//! each step is the caller's.

use std::mem::take;
use std::path::Path;

use burn::module::Module;
use burn::optim::{GradientsParams, ModuleOptimizer};
use burn::store::RecordError;
use burn::tensor::{Device, Int, Tensor, TensorData};

use super::adam::FusedAdam;
use super::cross_entropy::binary_cross_entropy_with_logits;
use super::muon::muon_and_adam;
use super::sample::Sample;

use crate::nets::success_net::{RADII, logit_index};
use crate::nets::{Optimiser, PathNet, SuccessNet, flex};
use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::scene::SIZE;
use crate::raster::{Bitmap, CELLS, CHANNELS, Coverage, SIDE};

/// What a trainer trains: `PathNet`, `SuccessNet`, `DynamicsNet`, `Dqn`.
pub trait Trainable: Module {}

impl<M: Module> Trainable for M {}

/// Why a checkpoint cannot be written or read.
#[derive(Debug, thiserror::Error)]
#[error(transparent)]
pub struct CheckpointError(#[from] RecordError);

/// What is trained, and its optimiser.
pub struct Trainer<M> {
    pub(super) nets: M,
    optimiser: ModuleOptimizer,
    pub(super) device: Device,
}

/// Samples as tensor data: scenes `[samples, 5, 64, 64]` and target maps `[samples, 4, 64, 64]`.
pub struct Batch {
    samples: usize,
    scenes: Vec<f32>,
    targets: Vec<f32>,
}

impl Batch {
    /// Collects the samples, each as it is or mirrored left to right.
    pub fn new<'a>(samples: impl Iterator<Item = (&'a Sample, bool)>) -> Batch {
        let mut batch = Batch { samples: 0, scenes: Vec::new(), targets: Vec::new() };
        for (sample, mirrored) in samples {
            extend(&mut batch.scenes, &sample.scene, mirrored);
            extend(&mut batch.targets, &sample.targets, mirrored);
            batch.samples += 1;
        }
        batch
    }
}

/// Scenes with labelled balls as tensor data: scenes `[scenes, 5, 64, 64]`; for each ball the index of its logit among
/// the logits `[scenes, RADII, 64, 64]`, and its label, 1 if it solved and 0 if not.
#[derive(Default)]
pub struct SuccessBatch {
    count: usize,
    scenes: Vec<f32>,
    logit_indices: Vec<i64>,
    labels: Vec<f32>,
}

impl SuccessBatch {
    /// Adds a scene and labelled balls of it, as they are or mirrored left to right.
    ///
    /// # Errors
    /// If the success net does not score a ball (`success_net::logit_index`); the batch is then of no use.
    pub fn add(
        &mut self,
        scene: &[Coverage; CHANNELS],
        balls: impl Iterator<Item = (Ball, bool)>,
        mirrored: bool,
    ) -> Result<(), Invalid> {
        for channel in scene {
            let flipped = mirrored.then(|| channel.mirrored());
            self.scenes.extend(flipped.as_ref().unwrap_or(channel).to_f32());
        }
        for (ball, solved) in balls {
            let x = if mirrored { SIZE - ball.x } else { ball.x };
            let index = logit_index(Ball { x, ..ball })?;
            self.logit_indices.push((self.count * RADII * CELLS + index) as i64);
            self.labels.push(if solved { 1.0 } else { 0.0 });
        }
        self.count += 1;
        Ok(())
    }

    /// The scenes.
    pub(super) fn scenes(&mut self, device: &Device) -> Tensor<4> {
        let shape = [self.count, CHANNELS, SIDE, SIDE];
        Tensor::from_data(TensorData::new(take(&mut self.scenes), shape), device)
    }

    /// The loss of the balls' logits, among the logits `[scenes, RADII, 64, 64]`.
    pub(super) fn loss(self, logits: Tensor<4>, device: &Device) -> Tensor<1> {
        let balls = self.logit_indices.len();
        let indices = Tensor::<1, Int>::from_data(TensorData::new(self.logit_indices, [balls]), device);
        let labels = Tensor::<1>::from_data(TensorData::new(self.labels, [balls]), device);
        binary_cross_entropy_with_logits(logits.reshape([-1]).select(0, indices), labels)
    }
}

/// Appends images as values of 0 and 1.
pub(super) fn extend(values: &mut Vec<f32>, images: &[Bitmap], mirrored: bool) {
    for image in images {
        let image = if mirrored { image.mirrored() } else { *image };
        for row in image.rows() {
            values.extend_from_slice(&row);
        }
    }
}

impl Trainer<PathNet> {
    /// Returns a trainer of fresh nets, whose weights depend only on the seed.
    pub fn new(seed: u64) -> Trainer<PathNet> {
        Trainer::fresh(seed, PathNet::new)
    }

    /// One optimiser step on a batch; returns the losses of the four maps.
    pub fn step(&mut self, batch: Batch, learning_rate: f64) -> [f32; 4] {
        let tensor = |values: Vec<f32>, channels: usize| {
            Tensor::<4>::from_data(TensorData::new(values, [batch.samples, channels, SIDE, SIDE]), &self.device)
        };
        let logits = self.nets.forward(tensor(batch.scenes, CHANNELS));
        let targets = tensor(batch.targets, 4).chunk(4, 1);
        let losses: Vec<Tensor<1>> = logits
            .into_iter()
            .zip(targets)
            .map(|(map, target)| binary_cross_entropy_with_logits(map, target))
            .collect();
        self.backward_step(Tensor::cat(losses, 0), learning_rate).try_into().expect("four maps")
    }
}

impl Trainer<SuccessNet> {
    /// Returns a trainer of a fresh success net, whose weights depend only on the seed.
    pub fn new(seed: u64) -> Trainer<SuccessNet> {
        Trainer::fresh(seed, SuccessNet::new)
    }

    /// One optimiser step on a batch; returns the mean loss of a ball.
    pub fn step(&mut self, mut batch: SuccessBatch, learning_rate: f64) -> f32 {
        let logits = self.nets.forward(batch.scenes(&self.device));
        self.backward_step(batch.loss(logits, &self.device), learning_rate)[0]
    }
}

impl<M: Trainable> Trainer<M> {
    /// Returns the same trainer with another optimiser, for one that has made no step yet.
    pub fn with_optimiser(self, optimiser: Optimiser) -> Trainer<M> {
        let optimiser = match optimiser {
            Optimiser::Adam => FusedAdam.into(),
            Optimiser::Muon => muon_and_adam(),
        };
        Trainer { optimiser, ..self }
    }

    /// Returns a trainer that starts from these nets, with a fresh optimiser.
    pub fn from_nets(nets: M) -> Trainer<M> {
        Trainer { nets: nets.train(), optimiser: FusedAdam.into(), device: flex().autodiff() }
    }

    pub(super) fn fresh(seed: u64, new: impl FnOnce(&Device) -> M) -> Trainer<M> {
        let device = flex().autodiff();
        device.seed(seed);
        Trainer { nets: new(&device), optimiser: FusedAdam.into(), device }
    }

    /// One optimiser step on the sum of the losses; returns the separate losses.
    pub(super) fn backward_step(&mut self, losses: Tensor<1>, learning_rate: f64) -> Vec<f32> {
        let gradients = GradientsParams::from_grads(losses.clone().sum().backward(), &self.nets);
        self.nets = self.optimiser.step(learning_rate, self.nets.clone(), gradients);
        losses.into_data().iter::<f32>().collect()
    }

    /// Returns the nets as they are now, without autodiff.
    pub fn nets(&self) -> M {
        self.nets.valid()
    }

    /// Writes nets and optimiser to two files.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn save(&self, nets: &Path, optimiser: &Path) -> Result<(), CheckpointError> {
        self.nets.clone().save_file(nets)?;
        Ok(self.optimiser.save(optimiser)?)
    }

    /// Replaces nets and optimiser by those that `save` wrote.
    ///
    /// # Errors
    /// If a file cannot be read or does not fit.
    pub fn restore(self, nets: &Path, optimiser: &Path) -> Result<Trainer<M>, CheckpointError> {
        let Trainer { nets: fresh, optimiser: idle, device } = self;
        Ok(Trainer { nets: fresh.try_load_file(nets)?, optimiser: idle.load(optimiser)?, device })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nets::success_net::ball_at;
    use crate::puzzle::task::Task;
    use crate::raster::{ball_image, scene_coverage};

    const ROW: usize = 17;
    const COLUMN: usize = 5;

    /// A scene that is not its own mirror image, in all channels alike.
    fn scene() -> [Bitmap; CHANNELS] {
        [ball_image(Ball { x: 60.0, y: 100.0, r: 20.0 }); CHANNELS]
    }

    fn mirror(images: &[f32]) -> Vec<f32> {
        images.chunks(SIDE).flat_map(|row| row.iter().rev()).copied().collect()
    }

    #[test]
    fn a_mirrored_scene_has_its_balls_in_mirrored_cells() {
        let index = 3 * CELLS + ROW * SIDE + COLUMN;
        let balls = [(ball_at(index), true), (ball_at(index + 1), false)];
        let mut batch = SuccessBatch::default();
        let covered = scene_coverage(&Task::load("00002:007".parse().expect("an id")).expect("a task").scene);
        batch.add(&covered, balls.into_iter(), false).expect("balls of the scene");
        batch.add(&covered, balls.into_iter(), true).expect("balls of the scene");
        let mirrored = RADII * CELLS + 3 * CELLS + ROW * SIDE + SIDE - 1 - COLUMN;
        assert_eq!(batch.logit_indices, [index, index + 1, mirrored, mirrored - 1].map(|index| index as i64));
        assert_eq!(batch.labels, [1.0, 0.0, 1.0, 0.0]);
        let (plain, flipped) = batch.scenes.split_at(CHANNELS * CELLS);
        assert_eq!(flipped, mirror(plain));
        assert_ne!(flipped, plain);
    }

    #[test]
    fn scenes_and_targets_are_mirrored_together() {
        let target = ball_image(Ball { x: 200.0, y: 30.0, r: 9.0 });
        let sample = Sample { scene: scene(), targets: [target; 4] };
        let (plain, flipped) = (Batch::new([(&sample, false)].into_iter()), Batch::new([(&sample, true)].into_iter()));
        assert_eq!(flipped.scenes, mirror(&plain.scenes));
        assert_eq!(flipped.targets, mirror(&plain.targets));
        assert_ne!(flipped.targets, plain.targets);
    }

    /// Its logit would be one of the next scene, or beyond the logits.
    #[test]
    fn a_ball_that_the_success_net_does_not_score_is_refused() {
        let ball = Ball { x: 100.0, y: 100.0, r: 64.0 };
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let added = SuccessBatch::default().add(&scene_coverage(&scene), [(ball, true)].into_iter(), false);
        assert_eq!(added, Err(Invalid::Radius));
    }
}
