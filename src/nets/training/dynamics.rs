//! One optimiser step of the dynamics net.
//!
//! The loss is the sum of the binary cross-entropies of the three chances (of the ball's cell, of the ball, and from
//! its paths alone) and of the weighted mean distances of the coordinates and of the expected errors. Without these
//! two, the net's paths are whatever helps the chances: an ablation.

use burn::tensor::{Tensor, TensorData};

use super::cross_entropy::binary_cross_entropy_with_logits;
use super::success::SuccessBatch;
use super::trainer::Trainer;
use crate::nets::ball_batch::BallBatch;
use crate::nets::ball_head::{COORDINATES, POSITIONS, Starts, UNIT};
use crate::nets::{DynamicsNet, PathWeights};
use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::scene::SIZE;
use crate::raster::{CHANNELS, Coverage};

/// Weight of the mean distance between expected and actual errors, in `UNIT`.
const ERROR_WEIGHT: f64 = 0.1;

/// Scenes and balls, with the balls' outcomes and paths.
#[derive(Default)]
pub struct DynamicsBatch {
    /// The scenes, and all balls in them.
    cells: SuccessBatch,
    scenes: usize,
    /// The balls whose paths are learned.
    balls: BallBatch,
    labels: Vec<f32>,
    /// `[balls, COORDINATES]`, in `UNIT`.
    coordinates: Vec<f32>,
}

/// A ball, whether it solves, and its paths: x and y at each sample, first of the object, then of the ball, px.
type LabelledBall<'a> = (Ball, bool, &'a [u8]);

impl DynamicsBatch {
    /// Adds a scene with labelled balls, unchanged or mirrored left to right. The paths of the first `imagined` balls
    /// are learned too.
    ///
    /// # Errors
    ///
    /// If a ball has no cell (`success_net::logit_index`). The batch must then be discarded.
    pub fn add<'a>(
        &mut self,
        scene: &[Coverage; CHANNELS],
        starts: Starts,
        balls: impl Iterator<Item = LabelledBall<'a>> + Clone,
        imagined: usize,
        mirrored: bool,
    ) -> Result<(), Invalid> {
        self.cells.add(scene, balls.clone().map(|(ball, solved, _)| (ball, solved)), mirrored)?;
        let starts = if mirrored { starts.mirrored() } else { starts };
        for (ball, solved, paths) in balls.take(imagined) {
            let ball = Ball { x: if mirrored { SIZE - ball.x } else { ball.x }, ..ball };
            self.balls.add(self.scenes, ball, starts);
            self.labels.push(if solved { 1.0 } else { 0.0 });
            let coordinates = paths.iter().enumerate().map(|(index, &at)| {
                let mirrored = mirrored && index % 2 == 0;
                (if mirrored { SIZE as f32 - f32::from(at) } else { f32::from(at) }) / UNIT
            });
            self.coordinates.extend(coordinates);
        }
        self.scenes += 1;
        Ok(())
    }
}

impl Trainer<DynamicsNet> {
    /// Returns a trainer of a fresh net, whose weights depend only on the seed.
    pub fn new(seed: u64) -> Trainer<DynamicsNet> {
        Trainer::fresh(seed, DynamicsNet::new)
    }

    /// Takes one optimiser step on a batch. Returns the losses: those of the logits of the cells, of the balls and of
    /// the paths alone, and the weighted mean distances of a coordinate and of an expected error, both in `UNIT`.
    pub fn step(&mut self, mut batch: DynamicsBatch, paths: PathWeights, learning_rate: f64) -> Vec<f32> {
        let device = self.device.clone();
        let (logits, predictions) = self.nets.forward(batch.cells.scenes(&device), batch.balls.tensors(&device));
        let vector = |values: Vec<f32>| {
            let len = values.len();
            Tensor::<1>::from_data(TensorData::new(values, [len]), &device)
        };
        let count = batch.labels.len();
        let labels = vector(batch.labels);
        let real = vector(batch.coordinates).reshape([count, COORDINATES]);
        let apart = predictions.coordinates - real; // [balls, COORDINATES]
        let squared = apart.clone().detach().powi_scalar(2).reshape([count, POSITIONS, 2]);
        let distance = squared.sum_dim(2).squeeze_dim::<2>(2).sqrt(); // [balls, POSITIONS]
        let of_ball = labels.clone() * (paths.solving - 1.0) + 1.0; // [balls]
        let of_ball = (of_ball.clone() / of_ball.mean()).reshape([count, 1]);
        let losses = vec![
            batch.cells.loss(logits, &device),
            binary_cross_entropy_with_logits(predictions.logits.squeeze_dim::<1>(1), labels.clone()),
            binary_cross_entropy_with_logits(predictions.path_logits.squeeze_dim::<1>(1), labels),
            (apart.abs() * of_ball.clone()).mean() * paths.all,
            ((predictions.errors - distance).abs() * of_ball).mean() * ERROR_WEIGHT,
        ];
        self.backward_step(Tensor::cat(losses, 0), learning_rate)
    }
}
