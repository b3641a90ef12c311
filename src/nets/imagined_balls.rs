//! The dynamics net's answers for the balls of one scene, on plain slices.
//!
//! The same computation as `BallHead::forward`, in an order that does not depend on the processor: natively and in wasm
//! the answers are the same, bit for bit. PHYRE's world is symmetric, so the scene and its mirror image both answer,
//! and the answer is their mean.

use burn::nn::Linear;
use burn::tensor::Tensor;

use super::ball_head::{BallHead, COORDINATES, PLACES, POSITIONS, Starts, UNIT, ball_numbers, corners, places};
use super::conv::{Matrix, matmul};
use super::dynamics::{DynamicsNet, LEVELS, SceneFeatures};
use super::judge::logit_index;
use super::values;
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::{SAMPLES, SampledPaths};
use crate::puzzle::scene::{SIZE, Scene};

/// Balls whose answers are computed together: the columns of the matrix products.
const BLOCK: usize = 16;

/// What the mean of the three logits is multiplied by. Trained nets are too sure of new scenes, and the likeliest of
/// many balls are those that the net is most wrong about. Set by hand, not tuned.
const CONFIDENCE: f32 = 0.7;

/// What the net imagines for a ball.
#[derive(Clone, Debug, PartialEq)]
pub struct ImaginedBall {
    pub paths: SampledPaths,
    /// Expected distance between imagined and real positions at each sample: of the object, then of the ball, px.
    pub errors: [f32; POSITIONS],
    /// The logit of the chance that the ball solves: the mean of the one that is read from the paths and the features
    /// that draw them, of the one from the paths alone, and of the one of the ball's cell, times `CONFIDENCE`.
    pub logit: f32,
    /// The logit from the paths alone.
    pub path_logit: f32,
}

/// A scene that the net has read.
pub struct ReadScene {
    /// Logits of the balls on each cell, `[RADII, 64, 64]`.
    pub logits: Vec<f32>,
    head: PlainHead,
    /// The scene and its mirror image.
    views: [View; 2],
}

/// The features of a scene or of its mirror image.
struct View {
    starts: Starts,
    /// For each level `[side * side, channels]`: the features of a cell lie together, because a ball needs all of them.
    levels: Vec<Vec<f32>>,
    /// The output of the head's layer `scene`.
    code: Vec<f32>,
}

/// A linear layer on plain slices.
struct Layer {
    /// `[inputs, outputs]`
    weight: Vec<f32>,
    bias: Vec<f32>,
}

/// The layers of `BallHead`.
struct PlainHead {
    first: Layer,
    second: Layer,
    displacements: Layer,
    errors: Layer,
    chance: Layer,
    logit: Layer,
    path_chance: [Layer; 2],
    path_logit: Layer,
}

impl Layer {
    fn new(layer: &Linear) -> Layer {
        let bias = layer.bias.as_ref().expect("every layer has a bias").val();
        let vec = |data: burn::tensor::TensorData| data.try_into_vec().expect("the nets are of f32");
        Layer { weight: vec(layer.weight.val().into_data()), bias: vec(bias.into_data()) }
    }

    /// `[inputs, BLOCK]` in, `[outputs, BLOCK]` out.
    fn forward(&self, x: &[f32], relu: bool) -> Vec<f32> {
        let (inputs, outputs) = (x.len() / BLOCK, self.bias.len());
        let mut y = vec![0.0; outputs * BLOCK];
        if outputs == 1 {
            // The kernels multiply whole tiles of rows.
            for (x, weight) in x.chunks_exact(BLOCK).zip(&self.weight) {
                for (y, x) in y.iter_mut().zip(x) {
                    *y += weight * x;
                }
            }
        } else {
            let weight = Matrix::new(&self.weight, inputs, outputs, outputs).transposed();
            matmul(&mut y, BLOCK, weight, Matrix::new(x, inputs, BLOCK, BLOCK));
        }
        for (y, bias) in y.chunks_exact_mut(BLOCK).zip(&self.bias) {
            for y in y {
                *y += bias;
                if relu && *y < 0.0 {
                    *y = 0.0;
                }
            }
        }
        y
    }
}

impl DynamicsNet {
    /// Reads a scene and its mirror image, `[2, 5, 64, 64]`.
    pub(super) fn read(&self, scene: &Scene, images: Tensor<4>) -> ReadScene {
        let SceneFeatures { logits, levels, code } = self.encode(images);
        let head = &self.head;
        let [ours, mirrored]: [Tensor<4>; 2] = logits.chunk(2, 0).try_into().expect("two scenes");
        let logits = values((ours + mirrored.flip([3])) / 2.0);
        let starts = Starts::of(scene);
        let scene_layer = Layer::new(&head.scene);
        let code: Vec<f32> = code.into_data().try_into_vec().expect("the nets are of f32");
        let levels: Vec<Vec<f32>> = levels.into_iter().map(|level| values(level.permute([0, 2, 3, 1]))).collect();
        let view = |index: usize, starts: Starts| {
            let half = |all: &Vec<f32>| all[index * all.len() / 2..][..all.len() / 2].to_vec();
            let mut columns = vec![0.0; code.len() / 2 * BLOCK];
            for (column, value) in columns.chunks_exact_mut(BLOCK).zip(half(&code)) {
                column[0] = value;
            }
            let code = scene_layer.forward(&columns, true).chunks_exact(BLOCK).map(|row| row[0]).collect();
            View { starts, levels: levels.iter().map(half).collect(), code }
        };
        ReadScene { logits, head: PlainHead::new(head), views: [view(0, starts), view(1, starts.mirrored())] }
    }
}

impl PlainHead {
    fn new(head: &BallHead) -> PlainHead {
        PlainHead {
            first: Layer::new(&head.first),
            second: Layer::new(&head.second),
            displacements: Layer::new(&head.displacements),
            errors: Layer::new(&head.errors),
            chance: Layer::new(&head.chance),
            logit: Layer::new(&head.logit),
            path_chance: [Layer::new(&head.path_chance[0]), Layer::new(&head.path_chance[1])],
            path_logit: Layer::new(&head.path_logit),
        }
    }

    /// The answers for up to `BLOCK` balls.
    fn forward(&self, view: &View, balls: &[Ball]) -> Vec<ImaginedBall> {
        let inputs = self.first.weight.len() / self.first.bias.len();
        let mut column = vec![0.0; inputs * BLOCK];
        for (index, &ball) in balls.iter().enumerate() {
            let mut rows = column.chunks_exact_mut(BLOCK).map(|row| &mut row[index]);
            let mut push = |value: f32| *rows.next().expect("as many rows as features") = value;
            ball_numbers(ball, view.starts).into_iter().for_each(&mut push);
            view.code.iter().copied().for_each(&mut push);
            for (level, (side, channels)) in view.levels.iter().zip(LEVELS) {
                let corners = corners(side, ball).map(|(cell, weight)| (&level[cell * channels..][..channels], weight));
                for channel in 0..channels {
                    push(corners.iter().map(|&(cell, weight)| cell[channel] * weight).sum());
                }
            }
        }
        let mut hidden = self.second.forward(&self.first.forward(&column, true), true);
        let displacements = self.displacements.forward(&hidden, false);
        let mut errors = self.errors.forward(&hidden, false);
        errors.iter_mut().for_each(|error| *error = softplus(*error));
        let mut paths = displacements;
        for (index, &ball) in balls.iter().enumerate() {
            for (coordinate, row) in paths.chunks_exact_mut(BLOCK).enumerate() {
                let start = if coordinate < 2 * SAMPLES { view.starts.object } else { [ball.x as f32, ball.y as f32] };
                row[index] += start[coordinate % 2] / UNIT;
            }
        }
        paths.extend(&errors);
        let mut all_places = vec![0.0; PLACES * BLOCK];
        for (index, &ball) in balls.iter().enumerate() {
            for (row, place) in all_places.chunks_exact_mut(BLOCK).zip(places(ball, view.starts)) {
                row[index] = place;
            }
        }
        paths.extend(&all_places);
        hidden.extend(&paths);
        let logits = self.logit.forward(&self.chance.forward(&hidden, true), false);
        let from_paths = self.path_chance[1].forward(&self.path_chance[0].forward(&paths, true), true);
        let path_logits = self.path_logit.forward(&from_paths, false);
        let answer = |index: usize| {
            let at = |row: usize| paths[row * BLOCK + index] * UNIT;
            let path =
                |first: usize| std::array::from_fn(|sample| [at(first + 2 * sample), at(first + 2 * sample + 1)]);
            ImaginedBall {
                paths: SampledPaths { object: path(0), ball: path(2 * SAMPLES) },
                errors: std::array::from_fn(|position| at(COORDINATES + position)),
                logit: logits[index],
                path_logit: path_logits[index],
            }
        };
        (0..balls.len()).map(answer).collect()
    }
}

impl ReadScene {
    /// Imagines what balls of the scene lead to.
    pub fn imagine(&self, balls: &[Ball]) -> Vec<ImaginedBall> {
        let mirror = |&ball: &Ball| Ball { x: SIZE - ball.x, ..ball };
        let mut imagined = Vec::with_capacity(balls.len());
        for block in balls.chunks(BLOCK) {
            let mirrored: Vec<Ball> = block.iter().map(mirror).collect();
            let [views, mirrored_view] = &self.views;
            let answers = self.head.forward(views, block);
            let mirrored = self.head.forward(mirrored_view, &mirrored);
            imagined.extend(answers.into_iter().zip(mirrored).map(|(ours, theirs)| ours.mean(&theirs)));
        }
        for (imagined, &ball) in imagined.iter_mut().zip(balls) {
            // Only a ball that is not valid has no cell.
            let of_cell = logit_index(ball).map_or(imagined.logit, |index| self.logits[index]);
            imagined.logit = CONFIDENCE * (imagined.logit + imagined.path_logit + of_cell) / 3.0;
        }
        imagined
    }
}

impl ImaginedBall {
    /// The mean of two answers, the other one for the mirror image.
    fn mean(mut self, mirrored: &ImaginedBall) -> ImaginedBall {
        let both = |path: &mut [[f32; 2]], other: &[[f32; 2]]| {
            for ([x, y], [u, v]) in path.iter_mut().zip(other) {
                (*x, *y) = ((*x + SIZE as f32 - u) / 2.0, (*y + v) / 2.0);
            }
        };
        both(&mut self.paths.object, &mirrored.paths.object);
        both(&mut self.paths.ball, &mirrored.paths.ball);
        for (error, other) in self.errors.iter_mut().zip(&mirrored.errors) {
            *error = (*error + other) / 2.0;
        }
        self.logit = (self.logit + mirrored.logit) / 2.0;
        self.path_logit = (self.path_logit + mirrored.path_logit) / 2.0;
        self
    }
}

/// ln(1 + e^x), with libm, so that wasm computes the same.
fn softplus(x: f32) -> f32 {
    x.max(0.0) + libm::log1pf(libm::expf(-x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nets::PathNet;
    use crate::nets::ball_head::{BallBatch, Predictions};
    use crate::nets::flex;
    use crate::nets::judge::RADII;
    use crate::puzzle::task::Task;
    use crate::raster::CELLS;

    #[test]
    fn the_plain_head_answers_as_burns_layers_do() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let mut nets = PathNet::new(&flex());
        nets.dynamics = Some(DynamicsNet::new(&flex()));
        let balls: Vec<Ball> = (0..21)
            .map(|i| Ball { x: 40.0 + 7.0 * f64::from(i), y: 30.0 + 9.5 * f64::from(i), r: 2.0 + f64::from(i) })
            .collect();
        let read = nets.read(&scene).expect("a dynamics net");
        assert_eq!(read.logits.len(), RADII * CELLS);
        let [view, _] = &read.views;
        let net = nets.dynamics.as_ref().expect("a dynamics net");
        let mut batch = BallBatch::default();
        balls.iter().for_each(|&ball| batch.add(0, ball, Starts::of(&scene)));
        let (_, predictions) = net.forward(nets.encode_coverage(&scene), batch.tensors(&flex()));
        let Predictions { coordinates, errors, logits, path_logits } = predictions;
        let vec = |data: burn::tensor::TensorData| data.try_into_vec::<f32>().expect("f32");
        let (coordinates, errors) = (vec(coordinates.into_data()), vec(errors.into_data()));
        let (logits, path_logits) = (vec(logits.into_data()), vec(path_logits.into_data()));
        let close = |a: f32, b: f32| assert!((a - b).abs() < 1e-3 * a.abs().max(1.0), "{a} {b}");
        let plain: Vec<ImaginedBall> = balls.chunks(BLOCK).flat_map(|block| read.head.forward(view, block)).collect();
        for (index, ball) in plain.iter().enumerate() {
            close(ball.logit, logits[index]);
            close(ball.path_logit, path_logits[index]);
            let all = ball.paths.object.iter().chain(&ball.paths.ball).flatten();
            all.zip(&coordinates[index * COORDINATES..]).for_each(|(&a, b)| close(a, b * UNIT));
            ball.errors.iter().zip(&errors[index * POSITIONS..]).for_each(|(&a, b)| close(a, b * UNIT));
        }
    }
}
