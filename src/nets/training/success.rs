//! One optimiser step of the success net: the mean binary cross-entropy of labelled balls.

use std::mem::take;

use burn::tensor::{Device, Int, Tensor, TensorData};

use super::cross_entropy::binary_cross_entropy_with_logits;
use super::trainer::Trainer;
use crate::nets::SuccessNet;
use crate::nets::success_net::{RADII, logit_index};
use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::scene::SIZE;
use crate::raster::{CELLS, CHANNELS, Coverage, SIDE};

/// Scenes with labelled balls as tensor data: scenes `[scenes, 5, 64, 64]`; for each ball, the index of its logit among
/// the logits `[scenes, RADII, 64, 64]`, and its label, 1 if it solved and 0 if not.
#[derive(Default)]
pub struct SuccessBatch {
    count: usize,
    scenes: Vec<f32>,
    logit_indices: Vec<i64>,
    labels: Vec<f32>,
}

impl SuccessBatch {
    /// Adds a scene with labelled balls, unchanged or mirrored left to right.
    ///
    /// # Errors
    ///
    /// If the success net does not score a ball (`success_net::logit_index`). The batch must then be discarded.
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

    /// Returns the loss of the balls' logits, among the logits `[scenes, RADII, 64, 64]`.
    pub(super) fn loss(self, logits: Tensor<4>, device: &Device) -> Tensor<1> {
        let balls = self.logit_indices.len();
        let indices = Tensor::<1, Int>::from_data(TensorData::new(self.logit_indices, [balls]), device);
        let labels = Tensor::<1>::from_data(TensorData::new(self.labels, [balls]), device);
        binary_cross_entropy_with_logits(logits.reshape([-1]).select(0, indices), labels)
    }
}

impl Trainer<SuccessNet> {
    /// Returns a trainer of a fresh success net, whose weights depend only on the seed.
    pub fn new(seed: u64) -> Trainer<SuccessNet> {
        Trainer::fresh(seed, SuccessNet::new)
    }

    /// Takes one optimiser step on a batch; returns the mean loss per ball.
    pub fn step(&mut self, mut batch: SuccessBatch, learning_rate: f64) -> f32 {
        let logits = self.nets.forward(batch.scenes(&self.device));
        self.backward_step(batch.loss(logits, &self.device), learning_rate)[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nets::success_net::ball_at;
    use crate::puzzle::task::Task;
    use crate::raster::scene_coverage;

    const ROW: usize = 17;
    const COLUMN: usize = 5;

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

    /// Its logit would belong to the next scene, or lie beyond the logits.
    #[test]
    fn a_ball_that_the_success_net_does_not_score_is_refused() {
        let ball = Ball { x: 100.0, y: 100.0, r: 64.0 };
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let added = SuccessBatch::default().add(&scene_coverage(&scene), [(ball, true)].into_iter(), false);
        assert_eq!(added, Err(Invalid::Radius));
    }
}
