//! Imagines balls in one scene with the dynamics net, on plain slices.
//!
//! Computes `BallHead::predict` with sums in an order that does not depend on the processor, so the results are the
//! same natively and in wasm, bit for bit. PHYRE's world is symmetric, so the net predicts for the scene and for its
//! mirror image, and the result is the mean.
//!
//! Everything between the inputs and the first ReLU is linear. The part that does not depend on the ball is therefore
//! multiplied by the first layer only once per scene: the code, and the cells of the coarse levels, whose products are
//! then interpolated.

use burn::nn::Linear;
use burn::tensor::Tensor;

use super::ball_columns::{Columns, Layer};
use super::ball_head::{
    BALL_NUMBERS, BallHead, COORDINATES, Features, HIDDEN, HeadInputs, PLACES, POSITIONS, SCENE_HIDDEN, Starts, UNIT,
    ball_numbers, corners, paths_at_rest, places,
};
use super::conv::panels::{COLUMNS, Panels};
use super::dynamics::{CODE, DynamicsNet, LEVELS, SceneFeatures};
use super::success_net::logit_index;
use super::values;
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::{SAMPLES, SampledPaths};
use crate::puzzle::scene::{SIZE, Scene};

/// Factor for the mean of the three logits. Trained nets are overconfident in new scenes, and the likeliest of many
/// balls are those about which the net is most wrong. Set by hand, not tuned.
const CONFIDENCE: f32 = 0.7;

/// Levels whose features are interpolated before the first layer, because they have more cells than a turn has balls.
const FINE_LEVELS: usize = 2;

/// The net's prediction for a ball.
#[derive(Clone, Debug, PartialEq)]
pub struct ImaginedBall {
    /// The imagined paths, px.
    pub paths: SampledPaths,
    /// Expected distance between imagined and real positions at each sample: of the object, then of the ball, px.
    pub errors: [f32; POSITIONS],
    /// The logit of the chance that the ball solves: the mean of three logits, times `CONFIDENCE`. One is read from the
    /// paths and the features that produce them, one from the paths alone, and one is that of the ball's cell.
    pub logit: f32,
    /// The logit from the paths alone.
    pub path_logit: f32,
}

/// A scene that the net has read.
pub struct ReadScene {
    /// Logits of the balls on each cell, `[RADII, 64, 64]`.
    pub logits: Vec<f32>,
    head: BallHead<Layer, FirstLayer>,
    /// The scene and its mirror image.
    views: [View; 2],
}

/// The features of a scene or of its mirror image.
struct View {
    starts: Starts,
    /// For each fine level, `[side * side, channels]`. The features of a cell are contiguous, because a ball needs them
    /// all.
    fine: Vec<Vec<f32>>,
    /// For each coarse level, `[side * side, HIDDEN[0]]`: the products of the cells' features and the first layer.
    coarse: Vec<Vec<f32>>,
    /// The bias of the first layer plus the product of that layer and the scene's code.
    code: Vec<f32>,
}

/// The first layer, split by its inputs.
struct FirstLayer {
    numbers: Panels,
    code: Panels,
    /// In the order of `LEVELS`.
    levels: Vec<Panels>,
    bias: Vec<f32>,
}

impl FirstLayer {
    fn new(layer: &Linear) -> FirstLayer {
        let weight = values(layer.weight.val());
        let mut rest = &weight[..];
        let mut part = |inputs: usize| {
            let (weight, others) = rest.split_at(inputs * HIDDEN[0]);
            rest = others;
            Panels::new(weight, HIDDEN[0])
        };
        FirstLayer {
            numbers: part(BALL_NUMBERS),
            code: part(SCENE_HIDDEN),
            levels: LEVELS.iter().map(|&(_, channels)| part(channels)).collect(),
            bias: values(layer.bias.as_ref().expect("every layer has a bias").val()),
        }
    }
}

impl DynamicsNet {
    /// Reads a scene and its mirror image, `[2, 5, 64, 64]`.
    pub(super) fn read(&self, scene: &Scene, images: Tensor<4>) -> ReadScene {
        let SceneFeatures { logits, levels, code } = self.encode(images);
        let [logits, mirrored]: [Tensor<4>; 2] = logits.chunk(2, 0).try_into().expect("two scenes");
        let logits = values((logits + mirrored.flip([3])) / 2.0);
        let head = self.head.with_layers(Layer::new, FirstLayer::new);
        let levels: Vec<Vec<f32>> = levels.into_iter().map(|level| values(level.permute([0, 2, 3, 1]))).collect();
        let codes: Vec<Vec<f32>> = values(code).chunks_exact(CODE).map(<[f32]>::to_vec).collect();
        let codes = Columns::new(&codes, CODE, |code| code.iter().copied()).linear(&head.scene).relu();
        let codes = Columns(head.first.code.multiply(&codes.0));
        let view = |index: usize, starts: Starts| {
            let of_view = |level: &Vec<f32>| level[index * level.len() / 2..][..level.len() / 2].to_vec();
            let levels = levels.iter().map(of_view);
            View {
                starts,
                fine: levels.clone().take(FINE_LEVELS).collect(),
                coarse: levels
                    .zip(&head.first.levels)
                    .skip(FINE_LEVELS)
                    .map(|(level, part)| product(&level, part))
                    .collect(),
                code: head.first.bias.iter().enumerate().map(|(row, bias)| bias + codes.get(row, index)).collect(),
            }
        };
        let starts = Starts::of(scene);
        let views = [view(0, starts), view(1, starts.mirrored())];
        ReadScene { logits, head, views }
    }
}

/// Returns the products of the features of cells and a part of the first layer, `[cells, HIDDEN[0]]`.
fn product(level: &[f32], part: &Panels) -> Vec<f32> {
    let cells: Vec<&[f32]> = level.chunks_exact(part.inputs()).collect();
    let of_cells = |cells: &[&[f32]]| {
        let features = Columns::new(cells, part.inputs(), |cell| cell.iter().copied());
        let product = Columns(part.multiply(&features.0));
        let of_cell = |column: usize| (0..HIDDEN[0]).map(move |row| (row, column));
        (0..cells.len()).flat_map(of_cell).map(|(row, column)| product.get(row, column)).collect::<Vec<_>>()
    };
    cells.chunks(COLUMNS).flat_map(of_cells).collect()
}

impl View {
    /// Returns the predictions for up to `COLUMNS` balls.
    fn imagine(&self, head: &BallHead<Layer, FirstLayer>, balls: &[Ball]) -> Vec<ImaginedBall> {
        let predictions = head.predict(HeadInputs {
            first: self.first(&head.first, balls),
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

    /// Returns the output of the first layer.
    fn first(&self, layer: &FirstLayer, balls: &[Ball]) -> Columns {
        let (fine_levels, coarse_levels) = LEVELS.split_at(FINE_LEVELS);
        let of_scene = Columns::new(balls, HIDDEN[0], |&ball| {
            let mut sums = self.code.clone();
            for (level, &(side, _)) in self.coarse.iter().zip(coarse_levels) {
                interpolate(&mut sums, level, side, ball);
            }
            sums
        });
        let numbers = Columns::new(balls, BALL_NUMBERS, |&ball| ball_numbers(ball, self.starts));
        let mut sums = of_scene.add(Columns(layer.numbers.multiply(&numbers.0)));
        for ((level, &(side, channels)), part) in self.fine.iter().zip(fine_levels).zip(&layer.levels) {
            let features = Columns::new(balls, channels, |&ball| {
                let mut features = vec![0.0; channels];
                interpolate(&mut features, level, side, ball);
                features
            });
            sums = sums.add(Columns(part.multiply(&features.0)));
        }
        sums
    }
}

/// Adds the interpolated values of a level, `[side * side, channels]`, at a ball.
fn interpolate(sums: &mut [f32], level: &[f32], side: usize, ball: Ball) {
    let channels = sums.len();
    let [first, second, third, fourth] = corners(side, ball)
        .map(|(cell, weight)| level[cell * channels..][..channels].iter().map(move |value| value * weight));
    for ((((sum, first), second), third), fourth) in sums.iter_mut().zip(first).zip(second).zip(third).zip(fourth) {
        *sum += first + second + third + fourth;
    }
}

impl ReadScene {
    /// Imagines balls in the scene.
    pub fn imagine(&self, balls: &[Ball]) -> Vec<ImaginedBall> {
        let [view, mirrored_view] = &self.views;
        // Neighbouring balls have zeros in the same features.
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
            // Only an invalid ball has no cell.
            let of_cell = logit_index(ball).map_or(imagined.logit, |index| self.logits[index]);
            imagined.logit = CONFIDENCE * (imagined.logit + imagined.path_logit + of_cell) / 3.0;
            imagined
        };
        imagined.into_iter().zip(balls).map(with_cell).collect()
    }
}

impl ImaginedBall {
    /// Returns the mean of the predictions for a ball and for its mirror image in the mirrored scene.
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
