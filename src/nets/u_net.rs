//! A U-Net (Ronneberger et al. 2015): an encoder-decoder in which each decoder layer also receives the encoder's output
//! of the same size, so that its maps are as sharp as the scene. The success net and the dynamics net are the same
//! U-Net except for their outputs. Its layers are fields of those nets, because the names of the parameters are those
//! in weights files.

use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::{Device, Tensor};

use super::conv::{conv_down, conv_up, fit_tiles, new_conv_down, new_conv_up};
use crate::raster::CHANNELS;

/// Channels after each of the five convolutions.
pub(crate) const WIDTHS: [usize; 5] = [16, 32, 64, 96, 128];

const _: () = assert!(fit_tiles(&WIDTHS), "a width is not a multiple of conv::matmul::TILE_ROWS");

/// Returns fresh layers: the convolutions, and the transposed convolutions that mirror them, the last of which has
/// `outputs` channels.
pub(crate) fn new_layers(outputs: usize, device: &Device) -> (Vec<Conv2d>, Vec<ConvTranspose2d>) {
    let down = (0..WIDTHS.len()).map(|layer| {
        let input = if layer == 0 { CHANNELS } else { WIDTHS[layer - 1] };
        new_conv_down(input, WIDTHS[layer], 4, device)
    });
    let up = (0..WIDTHS.len()).rev().map(|layer| {
        // All layers except the innermost receive the previous layer and, over the skip connection, the encoder's
        // output.
        let input = if layer == WIDTHS.len() - 1 { WIDTHS[layer] } else { 2 * WIDTHS[layer] };
        new_conv_up(input, if layer == 0 { outputs } else { WIDTHS[layer - 1] }, 4, device)
    });
    (down.collect(), up.collect())
}

/// The results of a U-Net.
pub(crate) struct Activations {
    /// The output of the last layer, without ReLU, `[batch, outputs, 64, 64]`.
    pub last: Tensor<4>,
    /// The inputs of the decoder's layers, both the previous layer and the encoder's output, coarsest first.
    pub skipped: Vec<Tensor<4>>,
    /// The innermost output of the encoder.
    pub code: Tensor<4>,
}

/// Applies the U-Net to images `[batch, 5, 64, 64]`.
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
