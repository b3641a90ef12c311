//! The two layers of all nets: a stride-2 convolution and a stride-2 transposed convolution, fast on the CPU.
//!
//! burn's own `conv2d` and `conv_transpose2d` define the result: they are the default bodies of `StridedConv`, which
//! ndarray runs. On flex, layers of at least 8 x 8 coarse cells are direct convolutions whose sums stay in registers
//! (`direct`). The deeper layers, with few cells and many weights, are one matrix product by im2col (Chellapilla et al.
//! 2006). The columns `[fine channels * kernel^2, samples * coarse cells]` hold, for each coarse cell, the patch of the
//! fine image that its kernel covers. With weights `W` `[coarse channels, fine channels * kernel^2]`, `conv_down` is `W
//! * im2col(x)` and `conv_up` is `col2im(W^T * x)`. Bias and ReLU follow in the same pass.
//!
//! burn's layers also support other strides, dilations and groups, which our nets do not use. Used by `hourglass`,
//! `u_net` and `dqn`.

// burn has deprecated its ndarray backend; it is kept as the reference backend of the differential tests.
#![allow(deprecated)]

use burn::backend::ops::{ConvOptions, ConvTransposeOptions};
use burn::backend::tensor::FloatTensor;
use burn::backend::{Backend, Dispatch, Flex, TensorMetadata, backend_extension};
use burn::nn::PaddingConfig2d;
use burn::nn::conv::{Conv2d, Conv2dConfig, ConvTranspose2d, ConvTranspose2dConfig};
use burn::tensor::{Device, Tensor, TensorData};

#[cfg(feature = "training")]
mod autodiff;
#[cfg(feature = "training")]
mod backward;
mod direct;
mod forward;
mod im2col;
mod matmul;
pub(crate) mod panels;
mod planes;
pub(crate) mod simd;
#[cfg(feature = "training")]
mod weight_gradient;

use forward::Layer;
use im2col::Geometry;

/// Returns whether layers with these output channels divide into whole tiles of the kernels. Each net asserts this at
/// compile time.
pub(crate) const fn fit_tiles(widths: &[usize]) -> bool {
    let mut index = 0;
    while index < widths.len() {
        if !widths[index].is_multiple_of(matmul::TILE_ROWS) {
            return false;
        }
        index += 1;
    }
    true
}

/// Returns a fresh layer for `conv_down`, from `input` to `output` channels; the kernel is 4 or 2 cells wide.
pub(crate) fn new_conv_down(input: usize, output: usize, kernel: usize, device: &Device) -> Conv2d {
    let padding = (kernel - 2) / 2;
    Conv2dConfig::new([input, output], [kernel; 2])
        .with_stride([2; 2])
        .with_padding(PaddingConfig2d::Explicit(padding, padding, padding, padding))
        .init(device)
}

/// Returns a fresh layer for `conv_up`, from `input` to `output` channels; the kernel is 4 or 2 cells wide.
pub(crate) fn new_conv_up(input: usize, output: usize, kernel: usize, device: &Device) -> ConvTranspose2d {
    let padding = (kernel - 2) / 2;
    ConvTranspose2dConfig::new([input, output], [kernel; 2]).with_stride([2; 2]).with_padding([padding; 2]).init(device)
}

/// Stride-2 convolution followed by ReLU: `[batch, fine channels, 2 n, 2 n]` to `[batch, coarse channels, n, n]`.
pub(crate) fn conv_down(layer: &Conv2d, x: Tensor<4>) -> Tensor<4> {
    let bias = layer.bias.as_ref().expect("every layer has a bias").val();
    Tensor::from_dispatch(Dispatch::conv_down(
        x.into_dispatch(),
        layer.weight.val().into_dispatch(),
        bias.into_dispatch(),
    ))
}

/// Stride-2 transposed convolution, followed by ReLU if `relu`: `[batch, coarse channels, n, n]` to
/// `[batch, fine channels, 2 n, 2 n]`.
pub(crate) fn conv_up(layer: &ConvTranspose2d, x: Tensor<4>, relu: bool) -> Tensor<4> {
    let bias = layer.bias.as_ref().expect("every layer has a bias").val();
    Tensor::from_dispatch(Dispatch::conv_up(
        x.into_dispatch(),
        layer.weight.val().into_dispatch(),
        bias.into_dispatch(),
        relu,
    ))
}

/// The two layers on the tensors of a backend, with stride 2 and a kernel of 4 with padding 1 or of 2 without padding.
/// Weights: `[coarse channels, fine channels, kernel, kernel]`.
#[backend_extension(Flex, NdArray: cfg(feature = "ndarray"), Autodiff: cfg(feature = "training"))]
pub(crate) trait StridedConv: Backend {
    /// See `conv_down`.
    fn conv_down(x: FloatTensor<Self>, weight: FloatTensor<Self>, bias: FloatTensor<Self>) -> FloatTensor<Self> {
        let padding = (weight.shape()[2] - 2) / 2;
        let options = ConvOptions::new([2; 2], [padding; 2], [1; 2], 1);
        Self::relu(Self::conv2d(x, weight, Some(bias), options))
    }

    /// See `conv_up`.
    fn conv_up(
        x: FloatTensor<Self>,
        weight: FloatTensor<Self>,
        bias: FloatTensor<Self>,
        relu: bool,
    ) -> FloatTensor<Self> {
        let padding = (weight.shape()[2] - 2) / 2;
        let options = ConvTransposeOptions::new([2; 2], [padding; 2], [0; 2], [1; 2], 1);
        let y = Self::conv_transpose2d(x, weight, Some(bias), options);
        if relu { Self::relu(y) } else { y }
    }
}

#[cfg(feature = "ndarray")]
impl StridedConv for burn::backend::NdArray {}

impl StridedConv for Flex {
    fn conv_down(x: FloatTensor<Flex>, weight: FloatTensor<Flex>, bias: FloatTensor<Flex>) -> FloatTensor<Flex> {
        flex_conv_down(x, weight, bias, false)
    }

    fn conv_up(
        x: FloatTensor<Flex>,
        weight: FloatTensor<Flex>,
        bias: FloatTensor<Flex>,
        relu: bool,
    ) -> FloatTensor<Flex> {
        flex_conv_up(x, weight, bias, relu, false)
    }
}

/// `conv_down` on flex; `fused` as in `DirectConv`.
fn flex_conv_down(
    x: FloatTensor<Flex>,
    weight: FloatTensor<Flex>,
    bias: FloatTensor<Flex>,
    fused: bool,
) -> FloatTensor<Flex> {
    let geometry = geometry(&weight, x.shape()[2] / 2);
    let [x, weight, bias] = [x, weight, bias].map(|tensor| tensor.to_contiguous());
    let y = Layer { geometry, weight: slice(&weight), fused }.conv_down(slice(&x), slice(&bias));
    images(y, geometry.coarse_channels, geometry.coarse_side)
}

/// `conv_up` on flex; `fused` as in `DirectConv`.
fn flex_conv_up(
    x: FloatTensor<Flex>,
    weight: FloatTensor<Flex>,
    bias: FloatTensor<Flex>,
    relu: bool,
    fused: bool,
) -> FloatTensor<Flex> {
    let geometry = geometry(&weight, x.shape()[2]);
    let [x, weight, bias] = [x, weight, bias].map(|tensor| tensor.to_contiguous());
    let y = Layer { geometry, weight: slice(&weight), fused }.conv_up(slice(&x), slice(&bias), relu);
    images(y, geometry.fine_channels, 2 * geometry.coarse_side)
}

fn geometry(weight: &FloatTensor<Flex>, coarse_side: usize) -> Geometry {
    let shape = weight.shape();
    Geometry { coarse_channels: shape[0], fine_channels: shape[1], coarse_side, kernel: shape[2] }
}

/// Returns the values of a contiguous tensor.
fn slice(tensor: &FloatTensor<Flex>) -> &[f32] {
    tensor.as_slice().expect("a contiguous tensor of f32")
}

/// Returns the tensor `[batch, channels, side, side]` of these values.
fn images(values: Vec<f32>, channels: usize, side: usize) -> FloatTensor<Flex> {
    let shape = [values.len() / (channels * side * side), channels, side, side];
    FloatTensor::<Flex>::from_data(TensorData::new(values, shape))
}
