//! One optimiser step of DQN: the mean binary cross-entropy of labelled balls.

use burn::tensor::{Tensor, TensorData};

use super::cross_entropy::binary_cross_entropy_with_logits;
use super::trainer::Trainer;
use crate::nets::dqn::{Dqn, inputs};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::SIZE;
use crate::raster::{CHANNELS, Coverage, SIDE};

/// Scenes with the same number of balls each, and the balls' labels.
#[derive(Default)]
pub struct DqnBatch {
    scenes: Vec<f32>,
    count: usize,
    /// x, y and r of each ball's action.
    actions: Vec<f32>,
    /// 1 for a ball that solves, 0 for one that does not.
    labels: Vec<f32>,
}

impl DqnBatch {
    /// Adds a scene with labelled balls, unchanged or mirrored left to right. Every scene of a batch has the same
    /// number of balls.
    pub fn add(&mut self, scene: &[Coverage; CHANNELS], balls: impl Iterator<Item = (Ball, bool)>, mirrored: bool) {
        for channel in scene {
            let flipped = mirrored.then(|| channel.mirrored());
            self.scenes.extend(flipped.as_ref().unwrap_or(channel).to_f32());
        }
        for (ball, solved) in balls {
            let ball = Ball { x: if mirrored { SIZE - ball.x } else { ball.x }, ..ball };
            self.actions.extend(inputs(ball.action()));
            self.labels.push(if solved { 1.0 } else { 0.0 });
        }
        self.count += 1;
    }
}

impl Trainer<Dqn> {
    /// Returns a trainer of a fresh net, whose weights depend only on the seed.
    pub fn new(seed: u64) -> Trainer<Dqn> {
        Trainer::fresh(seed, Dqn::new)
    }

    /// Takes one optimiser step on a batch; returns the mean loss per ball.
    pub fn step(&mut self, batch: DqnBatch, learning_rate: f64) -> f32 {
        let device = self.device.clone();
        let DqnBatch { scenes, count, actions, labels } = batch;
        let balls = labels.len() / count;
        let scenes = Tensor::<4>::from_data(TensorData::new(scenes, [count, CHANNELS, SIDE, SIDE]), &device);
        let actions = Tensor::<3>::from_data(TensorData::new(actions, [count, balls, 3]), &device);
        let labels = Tensor::<2>::from_data(TensorData::new(labels, [count, balls]), &device);
        let logits = self.nets.forward(&self.nets.encode(scenes), actions);
        self.backward_step(binary_cross_entropy_with_logits(logits, labels), learning_rate)[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::raster::scene_coverage;

    /// A scene with solving balls on its left and other balls on its right; nothing is simulated.
    fn batch(mirrored: bool) -> DqnBatch {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let balls = (0..8).map(|index| {
            let (x, solved) = if index < 4 { (40.0, true) } else { (200.0, false) };
            (Ball { x: x + f64::from(index), y: 30.0 + 20.0 * f64::from(index % 4), r: 8.0 }, solved)
        });
        let mut batch = DqnBatch::default();
        batch.add(&scene_coverage(&scene), balls, mirrored);
        batch
    }

    #[test]
    fn steps_lower_the_loss() {
        let mut trainer = Trainer::<Dqn>::new(1);
        let losses: Vec<f32> = (0..40).map(|_| trainer.step(batch(false), 3e-3)).collect();
        assert!((0.5..1.0).contains(&losses[0]), "{losses:?}");
        assert!(losses[39] < losses[0] / 2.0, "{losses:?}");
    }

    #[test]
    fn a_mirrored_scene_has_mirrored_actions() {
        let (plain, flipped) = (batch(false), batch(true));
        let rows = |scenes: &[f32]| scenes.chunks(SIDE).flat_map(|row| row.iter().rev().copied()).collect::<Vec<_>>();
        assert_eq!(flipped.scenes, rows(&plain.scenes));
        assert_ne!(flipped.scenes, plain.scenes);
        assert_eq!(flipped.labels, plain.labels);
        for (ours, theirs) in plain.actions.chunks(3).zip(flipped.actions.chunks(3)) {
            let width = SIZE as f32 / (SIZE - 1.0) as f32;
            assert!((ours[0] + theirs[0] - width).abs() < 1e-6 && ours[1..] == theirs[1..], "{ours:?} {theirs:?}");
        }
    }
}
