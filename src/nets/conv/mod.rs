//! Convolutions of stride two, halving a picture, and their transposes, doubling it, fast on the CPU.
//!
//! burn's own convolutions define what is computed: they are the default bodies below, which ndarray runs. On
//! flex both kinds are one matrix product on gathered patches, bias and relu in the same pass, several times as
//! fast. Used by `hourglass` and `judge`.

// burn names its ndarray backend deprecated; it stays as long as it is there to disagree with flex.
#![allow(deprecated)]

use burn::backend::ops::{ConvOptions, ConvTransposeOptions};
use burn::backend::tensor::FloatTensor;
use burn::backend::{Backend, Dispatch, Flex, TensorMetadata, backend_extension};
use burn::nn::PaddingConfig2d;
use burn::nn::conv::{Conv2d, Conv2dConfig, ConvTranspose2d, ConvTranspose2dConfig};
use burn::tensor::{Device, Tensor, TensorData};

#[cfg(not(target_arch = "wasm32"))]
mod backward;
mod forward;
mod im2col;
mod matmul;

use forward::Layer;
use im2col::Geometry;

/// A fresh layer for `halve`, from so many channels to so many; the kernel is 4 wide, or 2.
pub fn halving(from: usize, to: usize, kernel: usize, device: &Device) -> Conv2d {
    let padding = (kernel - 2) / 2;
    Conv2dConfig::new([from, to], [kernel; 2])
        .with_stride([2; 2])
        .with_padding(PaddingConfig2d::Explicit(padding, padding, padding, padding))
        .init(device)
}

/// A fresh layer for `double`, from so many channels to so many; the kernel is 4 wide, or 2.
pub fn doubling(from: usize, to: usize, kernel: usize, device: &Device) -> ConvTranspose2d {
    let padding = (kernel - 2) / 2;
    ConvTranspose2dConfig::new([from, to], [kernel; 2]).with_stride([2; 2]).with_padding([padding; 2]).init(device)
}

/// Half as wide: `[batch, wide, 2 n, 2 n]` to `[batch, narrow, n, n]`, below zero cut off.
pub fn halve(convolution: &Conv2d, x: Tensor<4>) -> Tensor<4> {
    let bias = convolution.bias.as_ref().expect("every layer has a bias").val();
    Tensor::from_dispatch(Dispatch::halve(
        x.into_dispatch(),
        convolution.weight.val().into_dispatch(),
        bias.into_dispatch(),
    ))
}

/// Twice as wide: `[batch, narrow, n, n]` to `[batch, wide, 2 n, 2 n]`, below zero cut off if `positive`.
pub fn double(convolution: &ConvTranspose2d, x: Tensor<4>, positive: bool) -> Tensor<4> {
    let bias = convolution.bias.as_ref().expect("every layer has a bias").val();
    Tensor::from_dispatch(Dispatch::double(
        x.into_dispatch(),
        convolution.weight.val().into_dispatch(),
        bias.into_dispatch(),
        positive,
    ))
}

/// The two operations on the tensors of a backend. Stride 2; kernel 4 and padding 1, or kernel 2 and none.
#[backend_extension(Flex, NdArray: cfg(feature = "ndarray"), Autodiff: cfg(not(target_arch = "wasm32")))]
pub trait StridedOps: Backend {
    /// A convolution and relu. Weights: `[narrow, wide, kernel, kernel]`.
    fn halve(x: FloatTensor<Self>, weight: FloatTensor<Self>, bias: FloatTensor<Self>) -> FloatTensor<Self> {
        let padding = (weight.shape()[2] - 2) / 2;
        let options = ConvOptions::new([2; 2], [padding; 2], [1; 2], 1);
        Self::relu(Self::conv2d(x, weight, Some(bias), options))
    }

    /// A transposed convolution, and relu if `positive`. Weights: `[narrow, wide, kernel, kernel]`.
    fn double(
        x: FloatTensor<Self>,
        weight: FloatTensor<Self>,
        bias: FloatTensor<Self>,
        positive: bool,
    ) -> FloatTensor<Self> {
        let padding = (weight.shape()[2] - 2) / 2;
        let options = ConvTransposeOptions::new([2; 2], [padding; 2], [0; 2], [1; 2], 1);
        let y = Self::conv_transpose2d(x, weight, Some(bias), options);
        if positive { Self::relu(y) } else { y }
    }
}

#[cfg(feature = "ndarray")]
impl StridedOps for burn::backend::NdArray {}

impl StridedOps for Flex {
    fn halve(x: FloatTensor<Flex>, weight: FloatTensor<Flex>, bias: FloatTensor<Flex>) -> FloatTensor<Flex> {
        let geometry = geometry(&weight, x.shape()[2] / 2);
        let y = numbers(&weight, |weight| {
            numbers(&bias, |bias| numbers(&x, |x| Layer { geometry, weight }.halve(x, bias)))
        });
        picture(y, geometry.narrow, geometry.side)
    }

    fn double(
        x: FloatTensor<Flex>,
        weight: FloatTensor<Flex>,
        bias: FloatTensor<Flex>,
        positive: bool,
    ) -> FloatTensor<Flex> {
        let geometry = geometry(&weight, x.shape()[2]);
        let y = numbers(&weight, |weight| {
            numbers(&bias, |bias| numbers(&x, |x| Layer { geometry, weight }.double(x, bias, positive)))
        });
        picture(y, geometry.wide, 2 * geometry.side)
    }
}

fn geometry(weight: &FloatTensor<Flex>, side: usize) -> Geometry {
    let shape = weight.shape();
    Geometry { narrow: shape[0], wide: shape[1], side, kernel: shape[2] }
}

/// Lends the numbers of a tensor, in order.
fn numbers<T>(tensor: &FloatTensor<Flex>, use_them: impl FnOnce(&[f32]) -> T) -> T {
    let tensor = tensor.to_contiguous();
    use_them(tensor.as_slice().expect("a contiguous tensor of f32"))
}

/// A tensor `[batch, channels, side, side]` of its numbers.
fn picture(numbers: Vec<f32>, channels: usize, side: usize) -> FloatTensor<Flex> {
    let shape = [numbers.len() / (channels * side * side), channels, side, side];
    FloatTensor::<Flex>::from_data(TensorData::new(numbers, shape))
}
