//! The balls of a batch of scenes as tensors, for the training of the dynamics net.

use burn::tensor::{Device, Int, Tensor, TensorData};

use super::ball_head::{BALL_NUMBERS, COORDINATES, PLACES, Starts, ball_numbers, corners, paths_at_rest, places};
use super::dynamics::LEVELS;
use crate::puzzle::action::Ball;

/// Balls of a batch of scenes as plain numbers.
#[derive(Default)]
pub struct BallBatch {
    count: usize,
    /// The scene of each ball.
    scenes: Vec<i64>,
    /// For each level and ball, the rows of its corners in the flattened level, and their weights.
    rows: [Vec<i64>; LEVELS.len()],
    weights: [Vec<f32>; LEVELS.len()],
    numbers: Vec<f32>,
    places: Vec<f32>,
    starts: Vec<f32>,
}

impl BallBatch {
    /// Adds a ball of the scene with this index in the batch.
    pub fn add(&mut self, scene: usize, ball: Ball, starts: Starts) {
        self.count += 1;
        self.scenes.push(scene as i64);
        for (level, (side, _)) in LEVELS.into_iter().enumerate() {
            for (cell, weight) in corners(side, ball) {
                self.rows[level].push((scene * side * side + cell) as i64);
                self.weights[level].push(weight);
            }
        }
        self.numbers.extend(ball_numbers(ball, starts));
        self.places.extend(places(ball, starts));
        self.starts.extend(paths_at_rest(ball, starts));
    }

    /// Returns the inputs of the balls as tensors, one row per ball.
    pub fn tensors(self, device: &Device) -> BallTensors {
        let count = self.count;
        let floats =
            |values: Vec<f32>, width: usize| Tensor::<2>::from_data(TensorData::new(values, [count, width]), device);
        let indices = |values: Vec<i64>| {
            let len = values.len();
            Tensor::<1, Int>::from_data(TensorData::new(values, [len]), device)
        };
        let corners = self.rows.into_iter().zip(self.weights).map(|(rows, weights)| {
            let weights = Tensor::<3>::from_data(TensorData::new(weights, [count, 4, 1]), device);
            (indices(rows), weights)
        });
        BallTensors {
            corners: corners.collect(),
            scenes: indices(self.scenes),
            numbers: floats(self.numbers, BALL_NUMBERS),
            places: floats(self.places, PLACES),
            starts: floats(self.starts, COORDINATES),
        }
    }
}

/// The inputs of the perceptron for these balls.
pub struct BallTensors {
    /// For each level, the rows of the corners `[4 balls]` and their weights `[balls, 4, 1]`.
    pub corners: Vec<(Tensor<1, Int>, Tensor<3>)>,
    /// `[balls]`
    pub scenes: Tensor<1, Int>,
    /// `[balls, BALL_NUMBERS]`
    pub numbers: Tensor<2>,
    /// `[balls, PLACES]`
    pub places: Tensor<2>,
    /// The coordinates of a path that stays where it starts, `[balls, COORDINATES]`, in `UNIT`.
    pub starts: Tensor<2>,
}
