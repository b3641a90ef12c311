//! DQN, the baseline of PHYRE (Bakhtin et al. 2019, "PHYRE: A New Benchmark for Physical Reasoning"): a classifier that
//! predicts how likely an action solves a scene.
//!
//! A residual net (He et al. 2016) reads the scene. Before its last stage, a perceptron of the action multiplies and
//! shifts each channel of the features (FiLM, Perez et al. 2018). The last stage, a maximum over the cells and a linear
//! layer turn them into the logit. The first layer after the modulation is linear in it, so it is convolved once per
//! scene, channel by channel, and each action only adds up the results. Ranking ten thousand actions takes less than a
//! second.
//!
//! The net is smaller than the published one, so that a CPU trains it in less than an hour. It reads 64 x 64 cells
//! instead of 256 x 256 pixels, and has one residual block per stage instead of two, none in the first stage, and at
//! most `FEATURES` channels instead of 512. Instead of batch normalisation it has residual branches that start at zero
//! (Zhang et al. 2019, "Fixup"). The action's perceptron has one more hidden layer, and a batch consists of mirrored
//! scenes and several balls of each scene. Native only: the page does not use it.

use burn::module::Module;
use burn::nn::conv::{Conv2d, Conv2dConfig};
use burn::nn::{Initializer, Linear, LinearConfig, PaddingConfig2d};
use burn::tensor::activation::relu;
use burn::tensor::{Device, Tensor, TensorData, s};

use super::conv::{conv_down, fit_tiles, new_conv_down};
use super::seeded;
use crate::puzzle::action::Action;
use crate::puzzle::scene::Scene;
use crate::raster::{CHANNELS, Coverage, SIDE, scene_coverage};

/// Channels after each of the three stages that depend only on the scene; each halves the side.
const WIDTHS: [usize; 3] = [16, 32, FEATURES];

/// Channels that the action modulates.
const FEATURES: usize = 96;

/// Cells per side of the modulated features.
const FEATURES_SIDE: usize = SIDE >> WIDTHS.len();

/// Channels of the last stage.
const LAST: usize = 64;

/// Cells of the last stage.
const LAST_CELLS: usize = FEATURES_SIDE * FEATURES_SIDE / 4;

/// Side of the kernel of the layer after the modulation.
const KERNEL: usize = 4;

/// Units in each of the two hidden layers of the action's perceptron.
const ACTION_HIDDEN: usize = 256;

/// Actions whose logits are computed together when a list is ranked.
const BLOCK: usize = 512;

const _: () = assert!(fit_tiles(&WIDTHS), "a width is not a multiple of conv::matmul::TILE_ROWS");

/// The net.
#[derive(Module, Debug)]
pub struct Dqn {
    /// The first layer of each stage.
    down: Vec<Conv2d>,
    /// The residual blocks of all stages but the first.
    blocks: Vec<ResidualBlock>,
    action: [Linear; 3],
    /// The layer after the modulation: the input of the last stage's residual branch, then its shortcut.
    modulated: Conv2d,
    last: Conv2d,
    logit: Linear,
}

/// Two convolutions whose result is added to their input.
#[derive(Module, Debug)]
struct ResidualBlock {
    first: Conv2d,
    second: Conv2d,
}

/// The net's results for scenes, valid for any actions in them.
pub struct SceneFeatures {
    /// The outputs of the layer after the modulation for each single channel of features,
    /// `[scenes, FEATURES, 2 LAST cells]`.
    of_features: Tensor<3>,
    /// The same for channels that are 1 everywhere, `[FEATURES, 2 LAST cells]`.
    of_ones: Tensor<2>,
}

/// Returns a fresh 3 x 3 convolution that keeps the side.
fn convolution(channels: usize, initializer: Option<Initializer>, device: &Device) -> Conv2d {
    let config = Conv2dConfig::new([channels; 2], [3; 2]).with_padding(PaddingConfig2d::Explicit(1, 1, 1, 1));
    initializer.map_or(config.clone(), |initializer| config.with_initializer(initializer)).init(device)
}

impl ResidualBlock {
    fn new(channels: usize, device: &Device) -> ResidualBlock {
        let second = convolution(channels, Some(Initializer::Zeros), device);
        ResidualBlock { first: convolution(channels, None, device), second }
    }

    fn forward(&self, x: Tensor<4>) -> Tensor<4> {
        let branch = self.second.forward(relu(self.first.forward(x.clone())));
        relu(x + branch)
    }
}

impl Dqn {
    /// Returns a fresh net with random weights from this seed.
    pub fn fresh(seed: u64) -> Dqn {
        Dqn::new(&seeded(seed))
    }

    pub(super) fn new(device: &Device) -> Dqn {
        let inputs = [CHANNELS, WIDTHS[0], WIDTHS[1]];
        let linear = |input, output| LinearConfig::new(input, output).init(device);
        Dqn {
            down: inputs
                .into_iter()
                .zip(WIDTHS)
                .map(|(input, width)| new_conv_down(input, width, KERNEL, device))
                .collect(),
            blocks: WIDTHS[1..].iter().map(|&width| ResidualBlock::new(width, device)).collect(),
            action: [
                linear(3, ACTION_HIDDEN),
                linear(ACTION_HIDDEN, ACTION_HIDDEN),
                linear(ACTION_HIDDEN, 2 * FEATURES),
            ],
            modulated: new_conv_down(FEATURES, 2 * LAST, KERNEL, device),
            last: convolution(LAST, Some(Initializer::Zeros), device),
            logit: linear(LAST, 1),
        }
    }

    /// Reads scenes, `[scenes, 5, 64, 64]`.
    pub fn encode(&self, scenes: Tensor<4>) -> SceneFeatures {
        let features = self.features(scenes); // [scenes, FEATURES, side, side]
        let [scenes, ..] = features.dims();
        let ones = Tensor::ones([1, FEATURES, FEATURES_SIDE, FEATURES_SIDE], &features.device());
        let padded = Tensor::cat(vec![features, ones], 0).pad((1, 1, 1, 1), 0.0);
        // For each position in the kernel, the cells that it covers: [scenes + 1, FEATURES, 1, cells].
        let covered = (0..KERNEL * KERNEL).map(|place| {
            let [row, column] = [place / KERNEL, place % KERNEL];
            let patch = padded.clone().slice(s![.., .., row..row + FEATURES_SIDE;2, column..column + FEATURES_SIDE;2]);
            patch.reshape([scenes + 1, FEATURES, 1, LAST_CELLS])
        });
        let columns = Tensor::cat(covered.collect(), 2).permute([1, 2, 0, 3]); // [FEATURES, places, scenes + 1, cells]
        let columns = columns.reshape([FEATURES, KERNEL * KERNEL, (scenes + 1) * LAST_CELLS]);
        let weight = self.modulated.weight.val().reshape([2 * LAST, FEATURES, KERNEL * KERNEL]).swap_dims(0, 1);
        let outputs = weight.matmul(columns).reshape([FEATURES, 2 * LAST, scenes + 1, LAST_CELLS]);
        let outputs = outputs.permute([2, 0, 1, 3]).reshape([scenes + 1, FEATURES, 2 * LAST * LAST_CELLS]);
        let [of_features, of_ones] =
            outputs.split_with_sizes(vec![scenes, 1], 0).try_into().expect("scenes and the ones");
        SceneFeatures { of_features, of_ones: of_ones.squeeze_dim(0) }
    }

    /// Returns the features that the action modulates, `[scenes, FEATURES, FEATURES_SIDE, FEATURES_SIDE]`.
    fn features(&self, scenes: Tensor<4>) -> Tensor<4> {
        let mut x = scenes;
        for (stage, down) in self.down.iter().enumerate() {
            x = conv_down(down, x);
            if let Some(block) = stage.checked_sub(1).map(|block| &self.blocks[block]) {
                x = block.forward(x);
            }
        }
        x
    }

    /// Returns the factor and the shift of each channel for actions, `[scenes, actions, FEATURES]` each.
    fn modulation(&self, actions: Tensor<3>) -> [Tensor<3>; 2] {
        let [first, second, last] = &self.action;
        let hidden = relu(second.forward(relu(first.forward(actions))));
        let [factor, shift] = last.forward(hidden).chunk(2, 2).try_into().expect("two halves");
        [factor + 1.0, shift]
    }

    /// Returns the output of the layer after the modulation, `[scenes * actions, 2 LAST, side, side]`.
    fn modulated(&self, features: &SceneFeatures, factor: Tensor<3>, shift: Tensor<3>) -> Tensor<4> {
        let [scenes, count, _] = factor.dims();
        let scaled = factor.matmul(features.of_features.clone()).reshape([scenes * count, 2 * LAST * LAST_CELLS]);
        let shifted = shift.reshape([scenes * count, FEATURES]).matmul(features.of_ones.clone());
        let bias = self.modulated.bias.as_ref().expect("every layer has a bias").val();
        let side = FEATURES_SIDE / 2;
        (scaled + shifted).reshape([scenes * count, 2 * LAST, side, side]) + bias.reshape([1, 2 * LAST, 1, 1])
    }

    /// Returns the logit of each action, `[scenes, actions]`, for scenes and actions in each, `[scenes, actions, 3]`.
    pub fn forward(&self, features: &SceneFeatures, actions: Tensor<3>) -> Tensor<2> {
        let [scenes, count, _] = actions.dims();
        let [factor, shift] = self.modulation(actions);
        let [branch, shortcut] = self.modulated(features, factor, shift).chunk(2, 1).try_into().expect("two halves");
        let x = relu(self.last.forward(relu(branch)) + shortcut); // [scenes * actions, LAST, side, side]
        let pooled: Tensor<2> = x.reshape([scenes * count, LAST, LAST_CELLS]).max_dim(2).squeeze_dim(2);
        self.logit.forward(pooled).reshape([scenes, count])
    }

    /// Returns the logits of actions in a scene.
    pub fn logits(&self, scene: &Scene, actions: &[Action]) -> Vec<f32> {
        let device = self.devices().into_iter().next().expect("the net has parameters");
        let channels: Vec<f32> = scene_coverage(scene).iter().flat_map(Coverage::to_f32).collect();
        let features = self.encode(Tensor::from_data(TensorData::new(channels, [1, CHANNELS, SIDE, SIDE]), &device));
        let of_block = |block: &[Action]| -> Vec<f32> {
            let numbers: Vec<f32> = block.iter().flat_map(|&action| inputs(action)).collect();
            let actions = Tensor::from_data(TensorData::new(numbers, [1, block.len(), 3]), &device);
            self.forward(&features, actions).into_data().try_into_vec().expect("the net is of f32")
        };
        actions.chunks(BLOCK).flat_map(of_block).collect()
    }
}

/// Returns the numbers of an action as inputs of the net.
pub fn inputs(Action { x, y, r }: Action) -> [f32; 3] {
    [x as f32, y as f32, r as f32]
}

#[cfg(test)]
mod tests {
    use burn::tensor::Distribution;

    use super::*;
    use crate::puzzle::task::Task;

    fn apart(a: Tensor<2>, b: Tensor<2>) -> f32 {
        (a - b).abs().max().into_scalar()
    }

    #[test]
    fn the_modulation_may_follow_the_layer_that_it_precedes() {
        let device = seeded(5);
        let dqn = Dqn::new(&device);
        let random = |shape: [usize; 3]| Tensor::<3>::random(shape, Distribution::Uniform(-1.0, 1.0), &device);
        let scenes = Tensor::random([2, CHANNELS, SIDE, SIDE], Distribution::Uniform(0.0, 1.0), &device);
        let (factor, shift) = (random([2, 3, FEATURES]), random([2, 3, FEATURES]));
        let ours = dqn.modulated(&dqn.encode(scenes.clone()), factor.clone(), shift.clone());
        assert_eq!(ours.dims(), [6, 2 * LAST, FEATURES_SIDE / 2, FEATURES_SIDE / 2]);
        let features = dqn.features(scenes).unsqueeze_dim::<5>(1); // [2, 1, FEATURES, side, side]
        let of_channels = |numbers: Tensor<3>| numbers.reshape([2, 3, FEATURES, 1, 1]);
        let modulated: Tensor<4> = (features * of_channels(factor) + of_channels(shift)).flatten(0, 1);
        let theirs = dqn.modulated.forward(modulated);
        let apart = apart(ours.flatten(1, 3), theirs.flatten(1, 3));
        assert!(apart < 1e-4, "{apart}");
    }

    #[test]
    fn a_list_of_actions_has_the_logits_of_its_actions() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let dqn = Dqn::fresh(6);
        let actions: Vec<Action> = (0..BLOCK + 3)
            .map(|index| index as f64 / (BLOCK + 3) as f64)
            .map(|at| Action { x: at, y: 1.0 - at, r: at * at })
            .collect();
        let logits = dqn.logits(&scene, &actions);
        assert_eq!(logits.len(), actions.len());
        for index in [0, BLOCK, BLOCK + 2] {
            let [alone] = dqn.logits(&scene, &actions[index..=index]).try_into().expect("one logit");
            assert!((alone - logits[index]).abs() < 1e-5, "{index}: {alone}, {}", logits[index]);
        }
        assert!(logits.iter().any(|logit| (logit - logits[0]).abs() > 1e-4), "the action matters");
    }
}
