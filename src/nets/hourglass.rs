//! One hourglass net: a stack of 64 x 64 images in, one 64 x 64 map of logits out.
//!
//! An encoder-decoder without skip connections (Harter et al. 2020): six stride-2 convolutions encode 64 x 64 cells
//! as a code of 256 values, six transposed ones decode it. At the code, the paper's 4 x 4 kernels meet data only with
//! their centre 2 x 2, the other taps only padding; so just the centre is kept, which changes no result.

use burn::module::Module;
use burn::nn::conv::{Conv2d, ConvTranspose2d};
use burn::tensor::{Device, Tensor};

use super::conv::{conv_down, conv_up, fit_tiles, new_conv_down, new_conv_up};

/// Channels after each of the six convolutions; the last is the length of the code.
const WIDTHS: [usize; 6] = [8, 16, 32, 64, 128, 256];

const _: () = assert!(fit_tiles(&WIDTHS), "a width is not a multiple of conv::matmul::TILE_ROWS");

/// An hourglass net. Its parameters are those of the paper's layers of 4 x 4 kernels without the dead taps.
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
        let mut net = Hourglass { down: down.collect(), up: up.collect() };
        if crate::suspects::on("init") {
            // A parameter must be a leaf of the gradients' graph.
            fn halve<const D: usize>(parameter: &mut burn::module::Param<Tensor<D>>) {
                *parameter = burn::module::Param::from_tensor((parameter.val() / 2.0).detach());
            }
            let (down, up) = (&mut net.down[5], &mut net.up[0]);
            halve(&mut down.weight);
            halve(&mut up.weight);
            down.bias.iter_mut().for_each(halve);
            up.bias.iter_mut().for_each(halve);
        }
        net
    }

    /// `[batch, channels, 64, 64]` in, logits `[batch, 1, 64, 64]` out.
    pub fn forward(&self, images: Tensor<4>) -> Tensor<4> {
        let code = self.down.iter().fold(images, |x, layer| conv_down(layer, x)); // [batch, 256, 1, 1]
        let (last, hidden) = self.up.split_last().expect("six layers");
        let x = hidden.iter().fold(code, |x, layer| conv_up(layer, x, true)); // [batch, 8, 32, 32]
        conv_up(last, x, false)
    }
}

/// Width of the kernel of a convolution and of the transposed one that mirrors it.
fn kernel(layer: usize) -> usize {
    if layer == 5 { 2 } else { 4 }
}
