//! One hourglass net: a stack of pictures in, one 64 x 64 map out.
//!
//! Six strided convolutions squeeze 64 x 64 cells to a code of 256 numbers, six transposed ones unfold it
//! again (Harter et al. 2020). Two layers meet at the code: there only the centre 2 x 2 of each 4 x 4 kernel
//! ever meets data, the rest falls on padding, so only the centre is kept; that changes no result.

use burn::module::Module;
use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::{Device, Tensor};

use super::conv::{double, doubling, halve, halving};

/// Channels after each of the six convolutions; the last is the length of the code.
const WIDTHS: [usize; 6] = [8, 16, 32, 64, 128, 256];

/// An hourglass net. Its numbers are those of the paper's layers of 4 x 4 kernels, the dead taps left out.
#[derive(Module, Debug)]
pub struct Hourglass {
    down: Vec<Conv2d>,
    up: Vec<ConvTranspose2d>,
}

impl Hourglass {
    /// A fresh net for so many input channels.
    pub fn new(channels: usize, device: &Device) -> Hourglass {
        let down = (0..6).map(|layer| {
            let input = if layer == 0 { channels } else { WIDTHS[layer - 1] };
            halving(input, WIDTHS[layer], kernel(layer), device)
        });
        let up = (0..6).rev().map(|layer| {
            let output = if layer == 0 { 1 } else { WIDTHS[layer - 1] };
            doubling(WIDTHS[layer], output, kernel(layer), device)
        });
        Hourglass { down: down.collect(), up: up.collect() }
    }

    /// Logits of the map. `[batch, channels, 64, 64]` in, `[batch, 1, 64, 64]` out.
    pub fn forward(&self, pictures: Tensor<4>) -> Tensor<4> {
        let code = self.down.iter().fold(pictures, |x, layer| halve(layer, x));
        let (last, hidden) = self.up.split_last().expect("six layers");
        let wide = hidden.iter().fold(code, |x, layer| double(layer, x, true));
        double(last, wide, false)
    }
}

/// How wide the kernel of a layer and of its mirror is.
fn kernel(layer: usize) -> usize {
    if layer == 5 { 2 } else { 4 }
}
