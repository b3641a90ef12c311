//! The perceptron of the dynamics net: from the hypercolumn at a ball to its paths and its chance.
//!
//! The chance is read from the imagined paths and from the features that produce them. A second chance is read from the
//! paths alone and shows how much they reveal. `BallHead::predict` is written once, for tensors in training and for
//! plain slices in `imagined_balls`.

use burn::module::Module;
use burn::nn::{Linear, LinearConfig};
use burn::tensor::activation::relu;
use burn::tensor::{Device, Tensor};

use super::ball_batch::BallTensors;
use super::dynamics::{CODE, LEVELS, SceneFeatures};
use super::success_net::RADII;
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

/// Number of inputs that describe a ball, the green object and its goal.
pub const BALL_NUMBERS: usize = 12 + RADII;

/// Number of inputs that describe the green object, its goal and the ball, for the chance from the paths alone.
pub const PLACES: usize = 5;

/// Outputs of the layer `scene`.
pub const SCENE_HIDDEN: usize = 64;

pub(super) const HIDDEN: [usize; 2] = [192, 128];
const CHANCE_HIDDEN: usize = 64;

/// Channels of the hypercolumn.
const fn hypercolumn() -> usize {
    let mut sum = 0;
    let mut level = 0;
    while level < LEVELS.len() {
        sum += LEVELS[level].1;
        level += 1;
    }
    sum
}

/// The layers of the perceptron: burn's, or those of `imagined_balls` for inference, which splits the first.
#[derive(Module, Debug)]
pub struct BallHead<L = Linear, First = L> {
    pub(super) scene: L,
    pub(super) first: First,
    second: L,
    /// Displacements of the coordinates from the start, in `UNIT`.
    displacements: L,
    /// Expected errors of the positions, in `UNIT`, before softplus.
    errors: L,
    chance: L,
    logit: L,
    path_chance: [L; 2],
    path_logit: L,
}

/// Features of some balls, and the operations of the perceptron.
pub trait Features: Clone {
    /// A linear layer with its bias.
    type Layer;

    /// Applies a linear layer.
    fn linear(&self, layer: &Self::Layer) -> Self;
    /// Returns the positive part.
    fn relu(self) -> Self;
    /// Returns ln(1 + e^x), written so that no x overflows.
    fn softplus(self) -> Self;
    /// Adds the features of `other` elementwise.
    fn add(self, other: Self) -> Self;
    /// Returns the features of all blocks, concatenated.
    fn concat(blocks: Vec<Self>) -> Self;
    /// Returns the same features without a gradient.
    fn detach(self) -> Self;
}

/// The inputs of the perceptron after its first layer, for some balls.
pub struct HeadInputs<F> {
    /// The output of the layer `first`. Its inputs are the ball's numbers, the output of the layer `scene`, and the
    /// features of each level at the ball, in the order of `LEVELS`.
    pub first: F,
    /// `PLACES` features.
    pub places: F,
    /// `COORDINATES` features: paths of bodies that stay where they start, in `UNIT`.
    pub starts: F,
}

/// Predictions for balls.
pub struct Predictions<F> {
    /// `COORDINATES` features, in `UNIT`.
    pub coordinates: F,
    /// Expected distances between imagined and real positions, in `UNIT`: `POSITIONS` features.
    pub errors: F,
    /// From the paths and the features that produce them: one feature.
    pub logits: F,
    /// From the paths alone: one feature.
    pub path_logits: F,
}

/// The starting positions of the green object and its goal, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Starts {
    /// The green object.
    pub object: [f32; 2],
    /// The goal.
    pub goal: [f32; 2],
}

impl Starts {
    /// Returns the starting positions in a scene.
    pub fn of(scene: &Scene) -> Starts {
        let start = |body: usize| [scene.bodies[body].x as f32, scene.bodies[body].y as f32];
        Starts { object: start(scene.body1), goal: start(scene.body2) }
    }

    /// Returns the positions mirrored left to right.
    pub fn mirrored(self) -> Starts {
        let mirror = |[x, y]: [f32; 2]| [SIZE as f32 - x, y];
        Starts { object: mirror(self.object), goal: mirror(self.goal) }
    }
}

/// Returns the four cells around a position in a level with this side, and their weights in bilinear interpolation.
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

/// Returns the numbers that describe a ball: positions in 0..=1, its position within its cell, its radius as such and
/// as hat functions, and the object and the goal relative to the ball.
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

/// Returns the inputs, besides the paths, of the chance from the paths alone.
pub fn places(ball: Ball, starts: Starts) -> [f32; PLACES] {
    let scale = SIZE as f32;
    let Starts { object, goal } = starts;
    [goal[0] / scale, goal[1] / scale, object[0] / scale, object[1] / scale, ball.r as f32 / 32.0]
}

/// Returns the coordinates of the two paths if both bodies stay where they start, in `UNIT`.
pub fn paths_at_rest(ball: Ball, starts: Starts) -> [f32; COORDINATES] {
    let ball = [ball.x as f32, ball.y as f32];
    std::array::from_fn(|coordinate| {
        let start = if coordinate < COORDINATES / 2 { starts.object } else { ball };
        start[coordinate % 2] / UNIT
    })
}

impl BallHead {
    /// Returns a head with random weights.
    pub fn new(device: &Device) -> BallHead {
        let linear = |input, output| LinearConfig::new(input, output).init(device);
        let paths = COORDINATES + POSITIONS + PLACES;
        BallHead {
            scene: linear(CODE, SCENE_HIDDEN),
            first: linear(BALL_NUMBERS + SCENE_HIDDEN + hypercolumn(), HIDDEN[0]),
            second: linear(HIDDEN[0], HIDDEN[1]),
            displacements: linear(HIDDEN[1], COORDINATES),
            errors: linear(HIDDEN[1], POSITIONS),
            chance: linear(HIDDEN[1] + paths, CHANCE_HIDDEN),
            logit: linear(CHANCE_HIDDEN, 1),
            path_chance: [linear(paths, CHANCE_HIDDEN), linear(CHANCE_HIDDEN, CHANCE_HIDDEN)],
            path_logit: linear(CHANCE_HIDDEN, 1),
        }
    }

    /// Predicts the outcome of each ball from the features of its scene.
    pub fn forward(&self, features: &SceneFeatures, balls: BallTensors) -> Predictions<Tensor<2>> {
        let BallTensors { corners, scenes, numbers, places, starts } = balls;
        let code = relu(self.scene.forward(features.code.clone())).select(0, scenes); // [balls, SCENE_HIDDEN]
        let hypercolumn = features.levels.iter().zip(corners).map(|(level, (rows, weights))| {
            let [batch, channels, side, _] = level.dims();
            let cells = level.clone().permute([0, 2, 3, 1]).reshape([batch * side * side, channels]);
            let around = cells.select(0, rows).reshape([-1, 4, channels as i32]); // [balls, 4, channels]
            (around * weights).sum_dim(1).squeeze_dim::<2>(1)
        });
        let seen = Features::concat([numbers, code].into_iter().chain(hypercolumn).collect());
        self.predict(HeadInputs { first: seen.linear(&self.first), places, starts })
    }
}

impl<L, First> BallHead<L, First> {
    /// Applies the perceptron after its first layer, in training and in inference. The blocks are in the order of the
    /// layers' inputs in weights files.
    pub fn predict<F: Features<Layer = L>>(&self, inputs: HeadInputs<F>) -> Predictions<F> {
        let HeadInputs { first, places, starts } = inputs;
        let hidden = first.relu().linear(&self.second).relu();
        let coordinates = starts.add(hidden.linear(&self.displacements));
        let errors = hidden.linear(&self.errors).softplus();
        let paths = F::concat(vec![coordinates.clone(), errors.clone(), places]);
        let chance = F::concat(vec![hidden, paths.clone()]).linear(&self.chance).relu();
        let [first, second] = &self.path_chance;
        // `detach` keeps the loss of these logits from changing the paths.
        let path_chance = paths.detach().linear(first).relu().linear(second).relu();
        Predictions {
            coordinates,
            errors,
            logits: chance.linear(&self.logit),
            path_logits: path_chance.linear(&self.path_logit),
        }
    }

    /// Returns the same perceptron with its layers converted.
    pub fn with_layers<M, N>(&self, convert: impl Fn(&L) -> M, convert_first: impl Fn(&First) -> N) -> BallHead<M, N> {
        BallHead {
            scene: convert(&self.scene),
            first: convert_first(&self.first),
            second: convert(&self.second),
            displacements: convert(&self.displacements),
            errors: convert(&self.errors),
            chance: convert(&self.chance),
            logit: convert(&self.logit),
            path_chance: self.path_chance.each_ref().map(&convert),
            path_logit: convert(&self.path_logit),
        }
    }
}

/// Features as `[balls, features]`, for training.
impl Features for Tensor<2> {
    type Layer = Linear;

    fn linear(&self, layer: &Linear) -> Tensor<2> {
        layer.forward(self.clone())
    }

    fn relu(self) -> Tensor<2> {
        relu(self)
    }

    fn softplus(self) -> Tensor<2> {
        relu(self.clone()) + self.abs().neg().exp().log1p()
    }

    fn add(self, other: Tensor<2>) -> Tensor<2> {
        self + other
    }

    fn concat(blocks: Vec<Tensor<2>>) -> Tensor<2> {
        Tensor::cat(blocks, 1)
    }

    fn detach(self) -> Tensor<2> {
        Tensor::detach(self)
    }
}
