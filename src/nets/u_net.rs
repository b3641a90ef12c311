//! A U-Net (Ronneberger et al. 2015): an encoder-decoder in which the decoder layer of each size also sees the
//! encoder's output of that size, so that its maps are as sharp as the scene. The success net and the dynamics net are
//! the same U-Net but for their outputs; its layers stay fields of theirs, because the names of the parameters are
//! those in weights files.

use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::{Device, Tensor};

use super::conv::{conv_down, conv_down_relu, conv_up, fit_tiles, new_conv_down, new_conv_up};
use crate::raster::CHANNELS;

/// Channels after each of the five convolutions.
pub(crate) const WIDTHS: [usize; 5] = [16, 32, 64, 128, 192];

const _: () = assert!(fit_tiles(&WIDTHS), "a width is not a multiple of conv::matmul::TILE_ROWS");

/// Returns fresh layers: the convolutions, and the transposed ones that mirror them, the last of which has `outputs`
/// channels.
pub(crate) fn new_layers(outputs: usize, device: &Device) -> (Vec<Conv2d>, Vec<ConvTranspose2d>) {
    let down = (0..WIDTHS.len()).map(|layer| {
        let input = if layer == 0 { CHANNELS } else { WIDTHS[layer - 1] };
        new_conv_down(input, WIDTHS[layer], 4, device)
    });
    let up = (0..WIDTHS.len()).rev().map(|layer| {
        // All but the innermost see the layer before and, over the skip connection, the encoder's output.
        let input = if layer == WIDTHS.len() - 1 { WIDTHS[layer] } else { 2 * WIDTHS[layer] };
        new_conv_up(input, if layer == 0 { outputs } else { WIDTHS[layer - 1] }, 4, device)
    });
    (down.collect(), up.collect())
}

/// What a U-Net makes of images.
pub(crate) struct Activations {
    /// The output of the last layer, without ReLU, `[batch, outputs, 64, 64]`.
    pub last: Tensor<4>,
    /// What the decoder's layers see, both the layer before and the encoder's output, coarsest first.
    pub skipped: Vec<Tensor<4>>,
    /// The innermost output of the encoder.
    pub code: Tensor<4>,
}

pub(crate) struct Stats {
    pub mean: Tensor<1>,
    pub var: Tensor<1>,
}

fn normalise(y: Tensor<4>, bias: Tensor<1>, stats: &mut Vec<Stats>) -> Tensor<4> {
    let c = y.dims()[1];
    let mean_of = |y: Tensor<4>| y.mean_dim(3).mean_dim(2).mean_dim(0);
    let mean = mean_of(y.clone());
    let d = y - mean.clone();
    let var = mean_of(d.clone() * d.clone());
    stats.push(Stats { mean: mean.reshape([c]), var: var.clone().reshape([c]) });
    let scale = (var + 1e-4).sqrt().recip();
    burn::tensor::activation::relu(d * scale + bias.reshape([1, c, 1, 1]))
}

pub(crate) fn forward_normalised(
    down: &[Conv2d],
    up: &[ConvTranspose2d],
    images: Tensor<4>,
) -> (Activations, Vec<Stats>) {
    let mut stats = Vec::new();
    let mut encoded = Vec::with_capacity(down.len());
    let mut x = images;
    for layer in down {
        x = normalise(conv_down_relu(layer, x, false), layer.bias.as_ref().expect("bias").val(), &mut stats);
        encoded.push(x.clone());
    }
    let code = encoded.pop().expect("a layer");
    let mut skipped = Vec::with_capacity(encoded.len());
    for layer in up {
        x = conv_up(layer, x, false);
        if let Some(skip) = encoded.pop() {
            x = normalise(x, layer.bias.as_ref().expect("bias").val(), &mut stats);
            x = Tensor::cat(vec![x, skip], 1);
            skipped.push(x.clone());
        }
    }
    (Activations { last: x, skipped, code }, stats)
}

/// `[batch, 5, 64, 64]` in.
pub(crate) fn forward(down: &[Conv2d], up: &[ConvTranspose2d], images: Tensor<4>) -> Activations {
    let mut encoded = Vec::with_capacity(down.len());
    let mut x = images;
    for layer in down {
        x = conv_down(layer, x);
        encoded.push(x.clone());
    }
    let code = encoded.pop().expect("a layer");
    let mut skipped = Vec::with_capacity(encoded.len());
    for layer in up {
        x = conv_up(layer, x, !encoded.is_empty());
        if let Some(skip) = encoded.pop() {
            x = Tensor::cat(vec![x, skip], 1);
            skipped.push(x.clone());
        }
    }
    Activations { last: x, skipped, code }
}
