//! The perceptron of the dynamics net: from the hypercolumn at a ball to its paths and its chance.
//!
//! The chance is read from the imagined paths and from the features that draw them. A second one is read from the paths
//! alone: it shows how much the paths say.

use burn::module::Module;
use burn::nn::{Linear, LinearConfig};
use burn::tensor::activation::relu;
use burn::tensor::{Device, Int, Tensor, TensorData};

use super::dynamics::{CODE, LEVELS, SceneFeatures};
use super::judge::RADII;
use crate::puzzle::action::{Ball, RADIUS};
use crate::puzzle::sampled_paths::SAMPLES;
use crate::puzzle::scene::{SIZE, Scene};
use crate::raster::PX_PER_CELL;

/// Coordinates of the two paths of a ball: x and y at each sample, first of the object, then of the ball.
pub const COORDINATES: usize = 4 * SAMPLES;

/// Positions of the two paths of a ball.
pub const POSITIONS: usize = 2 * SAMPLES;

/// Unit of the net's displacements and errors, px.
pub const UNIT: f32 = 64.0;

/// Numbers that describe a ball and the two bodies of the goal.
pub const BALL_NUMBERS: usize = 12 + RADII;

/// Numbers that describe the two bodies of the goal and the ball, for the chance from the paths alone.
pub const PLACES: usize = 5;

const SCENE_HIDDEN: usize = 64;
const HIDDEN: [usize; 2] = [192, 128];
const CHANCE_HIDDEN: usize = 64;

/// Channels of the hypercolumn.
const fn hypercolumn() -> usize {
    let (mut sum, mut level) = (0, 0);
    while level < LEVELS.len() {
        sum += LEVELS[level].1;
        level += 1;
    }
    sum
}

/// The perceptron.
#[derive(Module, Debug)]
pub struct BallHead {
    pub(super) scene: Linear,
    pub(super) first: Linear,
    pub(super) second: Linear,
    /// Displacements of the coordinates from the start, in `UNIT`.
    pub(super) displacements: Linear,
    /// Expected errors of the positions, in `UNIT`, before softplus.
    pub(super) errors: Linear,
    pub(super) chance: Linear,
    pub(super) logit: Linear,
    pub(super) path_chance: [Linear; 2],
    pub(super) path_logit: Linear,
}

/// Where the bodies of the goal start, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Starts {
    pub object: [f32; 2],
    pub goal: [f32; 2],
}

impl Starts {
    pub fn of(scene: &Scene) -> Starts {
        let start = |body: usize| [scene.bodies[body].x as f32, scene.bodies[body].y as f32];
        Starts { object: start(scene.body1), goal: start(scene.body2) }
    }

    /// Mirrored left to right.
    pub fn mirrored(self) -> Starts {
        let mirror = |[x, y]: [f32; 2]| [SIZE as f32 - x, y];
        Starts { object: mirror(self.object), goal: mirror(self.goal) }
    }
}

/// The four cells around a position in a level of this side, and their weights in the bilinear interpolation.
pub fn corners(side: usize, ball: Ball) -> [(usize, f32); 4] {
    let axis = |at: f64| {
        let position = (at / SIZE * side as f64 - 0.5).clamp(0.0, (side - 1) as f64);
        let low = position as usize;
        (low, (low + 1).min(side - 1), (position - low as f64) as f32)
    };
    let ((left, right, u), (bottom, top, v)) = (axis(ball.x), axis(ball.y));
    [
        (bottom * side + left, (1.0 - u) * (1.0 - v)),
        (bottom * side + right, u * (1.0 - v)),
        (top * side + left, (1.0 - u) * v),
        (top * side + right, u * v),
    ]
}

/// Returns the numbers that describe a ball: positions in 0..=1, where it is in its cell, its radius alone and as hat
/// functions, and how object and goal lie to it.
pub fn ball_numbers(ball: Ball, starts: Starts) -> [f32; BALL_NUMBERS] {
    let scale = SIZE as f32;
    let (x, y) = (ball.x as f32, ball.y as f32);
    let cell = |at: f32| at / PX_PER_CELL as f32 - (at / PX_PER_CELL as f32).floor() - 0.5;
    let fraction = ((ball.r - RADIUS.start()) / (RADIUS.end() - RADIUS.start())) as f32;
    let mut numbers = [0.0; BALL_NUMBERS];
    numbers[..12].copy_from_slice(&[
        x / scale,
        y / scale,
        fraction,
        cell(x),
        cell(y),
        fraction * fraction,
        (starts.object[0] - x) / scale,
        (starts.object[1] - y) / scale,
        (starts.goal[0] - x) / scale,
        (starts.goal[1] - y) / scale,
        (starts.goal[0] - starts.object[0]) / scale,
        (starts.goal[1] - starts.object[1]) / scale,
    ]);
    for (radius, hat) in numbers[12..].iter_mut().enumerate() {
        *hat = (1.0 - (fraction * (RADII - 1) as f32 - radius as f32).abs()).max(0.0);
    }
    numbers
}

/// Returns the numbers that the chance from the paths alone sees beside them.
pub fn places(ball: Ball, starts: Starts) -> [f32; PLACES] {
    let scale = SIZE as f32;
    let [x, y, u, v] = [starts.goal[0], starts.goal[1], starts.object[0], starts.object[1]].map(|at| at / scale);
    [x, y, u, v, ball.r as f32 / 32.0]
}

/// Balls of a batch of scenes as plain numbers.
#[derive(Default)]
pub struct BallBatch {
    count: usize,
    /// The scene of each ball.
    scenes: Vec<i64>,
    /// For each level and ball the rows of its corners in the flattened level, and their weights.
    rows: [Vec<i64>; LEVELS.len()],
    weights: [Vec<f32>; LEVELS.len()],
    numbers: Vec<f32>,
    places: Vec<f32>,
    starts: Vec<f32>,
}

impl BallBatch {
    /// Adds a ball of the scene with this number in the batch.
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
        let [object, start] = [starts.object, [ball.x as f32, ball.y as f32]];
        self.starts.extend([object, start].iter().flat_map(|start| start.repeat(SAMPLES)).map(|at| at / UNIT));
    }

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

/// Balls of a batch of scenes.
pub struct BallTensors {
    /// For each level the rows of the corners `[4 balls]` and their weights `[balls, 4, 1]`.
    corners: Vec<(Tensor<1, Int>, Tensor<3>)>,
    /// `[balls]`
    scenes: Tensor<1, Int>,
    /// `[balls, BALL_NUMBERS]`
    numbers: Tensor<2>,
    /// `[balls, PLACES]`
    places: Tensor<2>,
    /// The coordinates of a path that stays where it starts, `[balls, COORDINATES]`, in `UNIT`.
    starts: Tensor<2>,
}

/// What balls lead to.
pub struct Predictions {
    /// `[balls, COORDINATES]`, in `UNIT`.
    pub coordinates: Tensor<2>,
    /// Expected distances between imagined and real positions, `[balls, POSITIONS]`, in `UNIT`.
    pub errors: Tensor<2>,
    /// From the paths and the features that draw them, `[balls]`.
    pub logits: Tensor<1>,
    /// From the paths alone, `[balls]`.
    pub path_logits: Tensor<1>,
}

impl BallHead {
    pub fn new(device: &Device) -> BallHead {
        let linear = |input, output| LinearConfig::new(input, output).init(device);
        let paths = COORDINATES + POSITIONS;
        BallHead {
            scene: linear(CODE, SCENE_HIDDEN),
            first: linear(hypercolumn() + SCENE_HIDDEN + BALL_NUMBERS, HIDDEN[0]),
            second: linear(HIDDEN[0], HIDDEN[1]),
            displacements: linear(HIDDEN[1], COORDINATES),
            errors: linear(HIDDEN[1], POSITIONS),
            chance: linear(HIDDEN[1] + paths + PLACES, CHANCE_HIDDEN),
            logit: linear(CHANCE_HIDDEN, 1),
            path_chance: [linear(paths + PLACES, CHANCE_HIDDEN), linear(CHANCE_HIDDEN, CHANCE_HIDDEN)],
            path_logit: linear(CHANCE_HIDDEN, 1),
        }
    }

    /// Features of scenes and balls in them, in; what each ball leads to, out.
    pub fn forward(&self, features: &SceneFeatures, balls: BallTensors) -> Predictions {
        let BallTensors { corners, scenes, numbers, places, starts } = balls;
        let code = relu(self.scene.forward(features.code.clone())).select(0, scenes); // [balls, SCENE_HIDDEN]
        let mut columns: Vec<Tensor<2>> = vec![numbers, code];
        for (level, (rows, weights)) in features.levels.iter().zip(corners) {
            let [batch, channels, side, _] = level.dims();
            let cells = level.clone().permute([0, 2, 3, 1]).reshape([batch * side * side, channels]);
            let around = cells.select(0, rows).reshape([-1, 4, channels as i32]); // [balls, 4, channels]
            columns.push((around * weights).sum_dim(1).squeeze_dim(1));
        }
        let hidden = relu(self.first.forward(Tensor::cat(columns, 1)));
        let hidden = relu(self.second.forward(hidden)); // [balls, HIDDEN[1]]
        let coordinates = starts + self.displacements.forward(hidden.clone());
        let errors = softplus(self.errors.forward(hidden.clone()));
        let paths = Tensor::cat(vec![coordinates.clone(), errors.clone(), places], 1);
        let chance = relu(self.chance.forward(Tensor::cat(vec![hidden, paths.clone()], 1)));
        // Its loss does not change the paths: it only reads them.
        let from_paths = relu(self.path_chance[0].forward(paths.detach()));
        let from_paths = relu(self.path_chance[1].forward(from_paths));
        Predictions {
            coordinates,
            errors,
            logits: self.logit.forward(chance).squeeze_dim(1),
            path_logits: self.path_logit.forward(from_paths).squeeze_dim(1),
        }
    }
}

/// ln(1 + e^x), written so that no x overflows.
fn softplus<const D: usize>(x: Tensor<D>) -> Tensor<D> {
    relu(x.clone()) + x.abs().neg().exp().log1p()
}
