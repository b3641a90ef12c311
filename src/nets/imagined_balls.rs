//! What the dynamics net imagines for the balls of one scene, on plain slices.
//!
//! `BallHead::predict` with sums in an order that does not depend on the processor: natively and in wasm the answers
//! are the same, bit for bit. PHYRE's world is symmetric, so the net answers for the scene and for its mirror image,
//! and the answer is their mean.

use burn::nn::Linear;
use burn::tensor::Tensor;

use super::ball_head::{
    BALL_NUMBERS, BallHead, COORDINATES, Features, HeadInputs, PLACES, POSITIONS, SCENE_HIDDEN, Starts, UNIT,
    ball_numbers, corners, paths_at_rest, places,
};
use super::conv::panels::{COLUMNS, Panels};
use super::dynamics::{CODE, DynamicsNet, LEVELS, SceneFeatures};
use super::success_net::logit_index;
use super::values;
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::{SAMPLES, SampledPaths};
use crate::puzzle::scene::{SIZE, Scene};

/// What the mean of the three logits is multiplied by. Trained nets are too sure of new scenes, and the likeliest of
/// many balls are those that the net is most wrong about. Set by hand, not tuned.
const CONFIDENCE: f32 = 0.7;

/// What the net imagines for a ball.
#[derive(Clone, Debug, PartialEq)]
pub struct ImaginedBall {
    /// The imagined paths, px.
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
    head: BallHead<Layer>,
    /// The scene and its mirror image.
    views: [View; 2],
}

/// The features of a scene or of its mirror image.
struct View {
    starts: Starts,
    /// For each level `[side * side, channels]`: the features of a cell lie together, because a ball needs all of them.
    levels: Vec<Vec<f32>>,
    /// The output of the head's layer `scene`, `[SCENE_HIDDEN]`.
    code: Vec<f32>,
}

/// A linear layer on plain slices.
struct Layer {
    weight: Panels,
    bias: Vec<f32>,
}

impl Layer {
    fn new(layer: &Linear) -> Layer {
        let bias = values(layer.bias.as_ref().expect("every layer has a bias").val());
        Layer { weight: Panels::new(&values(layer.weight.val()), bias.len()), bias }
    }
}

/// Features of up to `COLUMNS` balls, `[features, COLUMNS]`: each ball has a column. What columns without a ball hold
/// does not matter.
#[derive(Clone)]
struct Columns(Vec<f32>);

impl Columns {
    /// The features of each ball, or of whatever else is to have a column.
    fn new<'a, B, F: IntoIterator<Item = f32>>(balls: &'a [B], count: usize, features: impl Fn(&'a B) -> F) -> Columns {
        let mut columns = vec![0.0; count * COLUMNS];
        for (index, ball) in balls.iter().enumerate() {
            for (row, feature) in columns.chunks_exact_mut(COLUMNS).zip(features(ball)) {
                row[index] = feature;
            }
        }
        Columns(columns)
    }

    fn get(&self, feature: usize, column: usize) -> f32 {
        self.0[feature * COLUMNS + column]
    }

    fn map(mut self, of: impl Fn(f32) -> f32) -> Columns {
        self.0.iter_mut().for_each(|value| *value = of(*value));
        self
    }
}

impl Features for Columns {
    type Layer = Layer;

    fn linear(&self, Layer { weight, bias }: &Layer) -> Columns {
        let mut y = weight.multiply(&self.0);
        for (y, bias) in y.chunks_exact_mut(COLUMNS).zip(bias) {
            y.iter_mut().for_each(|y| *y += bias);
        }
        Columns(y)
    }

    fn relu(self) -> Columns {
        self.map(|x| if x < 0.0 { 0.0 } else { x })
    }

    fn softplus(self) -> Columns {
        // With libm, so that wasm computes the same.
        self.map(|x| x.max(0.0) + libm::log1pf(libm::expf(-x.abs())))
    }

    fn add(mut self, other: Columns) -> Columns {
        self.0.iter_mut().zip(other.0).for_each(|(value, other)| *value += other);
        self
    }

    fn concat(blocks: Vec<Columns>) -> Columns {
        Columns(blocks.into_iter().map(|Columns(block)| block).collect::<Vec<_>>().concat())
    }

    fn detach(self) -> Columns {
        self
    }
}

impl DynamicsNet {
    /// Reads a scene and its mirror image, `[2, 5, 64, 64]`.
    pub(super) fn read(&self, scene: &Scene, images: Tensor<4>) -> ReadScene {
        let SceneFeatures { logits, levels, code } = self.encode(images);
        let [logits, mirrored]: [Tensor<4>; 2] = logits.chunk(2, 0).try_into().expect("two scenes");
        let logits = values((logits + mirrored.flip([3])) / 2.0);
        let head = self.head.with_layers(Layer::new);
        let levels: Vec<Vec<f32>> = levels.into_iter().map(|level| values(level.permute([0, 2, 3, 1]))).collect();
        let codes: Vec<Vec<f32>> = values(code).chunks_exact(CODE).map(<[f32]>::to_vec).collect();
        let codes = Columns::new(&codes, CODE, |code| code.iter().copied()).linear(&head.scene).relu();
        let view = |index: usize, starts: Starts| View {
            starts,
            levels: levels.iter().map(|level| level[index * level.len() / 2..][..level.len() / 2].to_vec()).collect(),
            code: (0..SCENE_HIDDEN).map(|feature| codes.get(feature, index)).collect(),
        };
        let starts = Starts::of(scene);
        let views = [view(0, starts), view(1, starts.mirrored())];
        ReadScene { logits, head, views }
    }
}

impl View {
    /// Returns what up to `COLUMNS` balls lead to.
    fn imagine(&self, head: &BallHead<Layer>, balls: &[Ball]) -> Vec<ImaginedBall> {
        let level_at_balls = |(level, (side, channels)): (&Vec<f32>, (usize, usize))| {
            Columns::new(balls, channels, |&ball| {
                let corners = corners(side, ball).map(|(cell, weight)| (&level[cell * channels..][..channels], weight));
                (0..channels).map(move |channel| corners.iter().map(|&(cell, weight)| cell[channel] * weight).sum())
            })
        };
        let predictions = head.predict(HeadInputs {
            numbers: Columns::new(balls, BALL_NUMBERS, |&ball| ball_numbers(ball, self.starts)),
            code: Columns::new(balls, SCENE_HIDDEN, |_| self.code.iter().copied()),
            hypercolumn: self.levels.iter().zip(LEVELS).map(level_at_balls).collect(),
            places: Columns::new(balls, PLACES, |&ball| places(ball, self.starts)),
            starts: Columns::new(balls, COORDINATES, |&ball| paths_at_rest(ball, self.starts)),
        });
        let imagined = |column: usize| {
            let coordinate = |index: usize| predictions.coordinates.get(index, column) * UNIT;
            let path = |first: usize| {
                std::array::from_fn(|sample| [coordinate(first + 2 * sample), coordinate(first + 2 * sample + 1)])
            };
            ImaginedBall {
                paths: SampledPaths { object: path(0), ball: path(2 * SAMPLES) },
                errors: std::array::from_fn(|position| predictions.errors.get(position, column) * UNIT),
                logit: predictions.logits.get(0, column),
                path_logit: predictions.path_logits.get(0, column),
            }
        };
        (0..balls.len()).map(imagined).collect()
    }
}

impl ReadScene {
    /// Imagines what balls of the scene lead to.
    pub fn imagine(&self, balls: &[Ball]) -> Vec<ImaginedBall> {
        let [view, mirrored_view] = &self.views;
        // Balls close together have zeros in the same features.
        let mut order: Vec<usize> = (0..balls.len()).collect();
        let cell = |at: f64, side: f64| (at / side) as i32;
        let cells = |Ball { x, y, .. }: Ball| [cell(y, 32.0), cell(x, 32.0), cell(y, 8.0), cell(x, 8.0)];
        order.sort_by_key(|&index| cells(balls[index]));
        let mut imagined = Vec::with_capacity(balls.len());
        for indices in order.chunks(COLUMNS) {
            let block: Vec<Ball> = indices.iter().map(|&index| balls[index]).collect();
            let mirrored_block: Vec<Ball> = block.iter().map(|&ball| Ball { x: SIZE - ball.x, ..ball }).collect();
            let answers = view.imagine(&self.head, &block);
            let mirrored = mirrored_view.imagine(&self.head, &mirrored_block);
            let means = answers.into_iter().zip(mirrored).map(|(answer, mirrored)| answer.mean(&mirrored));
            imagined.extend(indices.iter().zip(means));
        }
        imagined.sort_unstable_by_key(|&(index, _)| index);
        let with_cell = |((_, mut imagined), &ball): ((&usize, ImaginedBall), &Ball)| {
            // Only a ball that is not valid has no cell.
            let of_cell = logit_index(ball).map_or(imagined.logit, |index| self.logits[index]);
            imagined.logit = CONFIDENCE * (imagined.logit + imagined.path_logit + of_cell) / 3.0;
            imagined
        };
        imagined.into_iter().zip(balls).map(with_cell).collect()
    }
}

impl ImaginedBall {
    /// Returns the mean of the answers for a ball and for its mirror image in the mirrored scene.
    fn mean(mut self, mirrored: &ImaginedBall) -> ImaginedBall {
        let average = |path: &mut [[f32; 2]], mirrored: &[[f32; 2]]| {
            for ([x, y], [mirrored_x, mirrored_y]) in path.iter_mut().zip(mirrored) {
                *x = (*x + SIZE as f32 - mirrored_x) / 2.0;
                *y = (*y + mirrored_y) / 2.0;
            }
        };
        average(&mut self.paths.object, &mirrored.paths.object);
        average(&mut self.paths.ball, &mirrored.paths.ball);
        for (error, mirrored) in self.errors.iter_mut().zip(&mirrored.errors) {
            *error = (*error + mirrored) / 2.0;
        }
        self.logit = (self.logit + mirrored.logit) / 2.0;
        self.path_logit = (self.path_logit + mirrored.path_logit) / 2.0;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nets::PathNet;
    use crate::nets::ball_batch::BallBatch;
    use crate::nets::ball_head::Predictions;
    use crate::nets::flex;
    use crate::nets::success_net::RADII;
    use crate::puzzle::task::Task;
    use crate::raster::CELLS;

    #[test]
    fn the_plain_head_answers_as_burns_layers_do() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let mut nets = PathNet::fresh(0);
        nets.dynamics = Some(DynamicsNet::fresh(0));
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
        let [coordinates, errors, logits, path_logits] = [coordinates, errors, logits, path_logits].map(values);
        let close = |a: f32, b: f32| assert!((a - b).abs() < 1e-3 * a.abs().max(1.0), "{a} {b}");
        let plain: Vec<ImaginedBall> =
            balls.chunks(COLUMNS).flat_map(|block| view.imagine(&read.head, block)).collect();
        for (index, ball) in plain.iter().enumerate() {
            close(ball.logit, logits[index]);
            close(ball.path_logit, path_logits[index]);
            let all = ball.paths.object.iter().chain(&ball.paths.ball).flatten();
            all.zip(&coordinates[index * COORDINATES..]).for_each(|(&a, b)| close(a, b * UNIT));
            ball.errors.iter().zip(&errors[index * POSITIONS..]).for_each(|(&a, b)| close(a, b * UNIT));
        }
    }
}
