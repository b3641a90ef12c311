//! One hourglass net: a stack of 64 x 64 images in, one 64 x 64 map of logits out.
//!
//! An encoder-decoder without skip connections (Harter et al. 2020): six stride-2 convolutions encode 64 x 64 cells as
//! a code of 256 values, and six transposed convolutions decode it. At the code, only the centre 2 x 2 of the paper's 4
//! x 4 kernels meets data; the other taps meet padding. Only the centre is kept, which changes no result.

use burn::module::Module;
use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::{Device, Tensor};

use super::conv::{conv_down, conv_up, fit_tiles, new_conv_down, new_conv_up};

/// Channels after each of the six convolutions; the last is the length of the code.
const WIDTHS: [usize; 6] = [8, 16, 32, 64, 128, 256];

const _: () = assert!(fit_tiles(&WIDTHS), "a width is not a multiple of conv::matmul::TILE_ROWS");

/// An hourglass net. Its parameters are those of the paper's layers of 4 x 4 kernels, without the dead taps.
#[derive(Module, Debug)]
pub struct Hourglass {
    down: Vec<Conv2d>,
    up: Vec<ConvTranspose2d>,
}

impl Hourglass {
    /// Returns a fresh net for this number of input channels.
    pub fn new(channels: usize, device: &Device) -> Hourglass {
        let down = (0..6).map(|layer| {
            let input = if layer == 0 { channels } else { WIDTHS[layer - 1] };
            new_conv_down(input, WIDTHS[layer], kernel(layer), device)
        });
        let up = (0..6).rev().map(|layer| {
            let output = if layer == 0 { 1 } else { WIDTHS[layer - 1] };
            new_conv_up(WIDTHS[layer], output, kernel(layer), device)
        });
        Hourglass { down: down.collect(), up: up.collect() }
    }

    /// Returns the logits `[batch, 1, 64, 64]` of images `[batch, channels, 64, 64]`.
    pub fn forward(&self, images: Tensor<4>) -> Tensor<4> {
        let code = self.down.iter().fold(images, |x, layer| conv_down(layer, x)); // [batch, 256, 1, 1]
        let (last, hidden) = self.up.split_last().expect("six layers");
        let x = hidden.iter().fold(code, |x, layer| conv_up(layer, x, true)); // [batch, 8, 32, 32]
        conv_up(last, x, false)
    }
}

/// Returns the kernel width of a convolution and of the transposed convolution that mirrors it.
fn kernel(layer: usize) -> usize {
    if layer == 5 { 2 } else { 4 }
}
