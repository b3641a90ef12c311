//! The logistic function, and softplus, its integral, the same to the bit natively and in wasm.
//!
//! burn's version calls the platform library's exponential function one value at a time, and the libraries differ in
//! the last bits. This one uses a polynomial without fused operations, on vector registers.

// burn has deprecated its ndarray backend; it is kept as the reference backend of the differential tests.
#![allow(deprecated)]

#[cfg(feature = "training")]
use burn::backend::autodiff::{
    checkpoint::{base::Checkpointer, strategy::CheckpointStrategy},
    grads::Gradients,
    ops::{Backward, Ops, OpsKind},
};
use burn::backend::tensor::FloatTensor;
use burn::backend::{Backend, Dispatch, Flex, TensorMetadata, backend_extension};
use burn::tensor::{Tensor, TensorData};
use pulp::{Simd, WithSimd};
#[cfg(not(target_arch = "wasm32"))]
use rayon::prelude::*;

use super::conv::simd::vectorize;

/// Values that one core processes at a time: 64 KiB.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) const CHUNK: usize = 1 << 14;

/// Returns 1 / (1 + e^-x) for every x.
pub(crate) fn logistic<const D: usize>(x: Tensor<D>) -> Tensor<D> {
    Tensor::from_dispatch(Dispatch::logistic(x.into_dispatch()))
}

/// The function on the tensors of a backend. burn's version defines the result; ndarray runs it.
#[backend_extension(Flex, NdArray: cfg(feature = "ndarray"), Autodiff: cfg(feature = "training"))]
pub(crate) trait Logistic: Backend {
    /// See `logistic`.
    fn logistic(x: FloatTensor<Self>) -> FloatTensor<Self> {
        Self::sigmoid(x)
    }
}

#[cfg(feature = "ndarray")]
impl Logistic for burn::backend::NdArray {}

#[cfg(all(feature = "ndarray", feature = "training"))]
impl<C: CheckpointStrategy> Logistic for burn::backend::Autodiff<burn::backend::NdArray, C> {}

impl Logistic for Flex {
    fn logistic(x: FloatTensor<Flex>) -> FloatTensor<Flex> {
        map(&x, &x, |x, _| logistic_and_exp(x).0)
    }
}

#[cfg(feature = "training")]
impl<C: CheckpointStrategy> Logistic for burn::backend::Autodiff<Flex, C> {
    fn logistic(x: FloatTensor<Self>) -> FloatTensor<Self> {
        let y = Flex::logistic(x.primitive().clone());
        match LogisticStep.prepare::<C>([x.node()]).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish(y.clone(), y),
            OpsKind::UnTracked(step) => step.finish(y),
        }
    }
}

#[cfg(feature = "training")]
#[derive(Debug)]
struct LogisticStep;

#[cfg(feature = "training")]
impl Backward<Flex, 1> for LogisticStep {
    /// The values of the function.
    type State = FloatTensor<Flex>;

    fn backward(self, ops: Ops<FloatTensor<Flex>, 1>, store: &mut Gradients, _: &mut Checkpointer) {
        let dy = store.consume::<Flex>(&ops.node);
        if let [Some(x)] = ops.parents {
            store.register::<Flex>(x.id, map(&ops.state, &dy, |y, dy| dy * y * (1.0 - y)));
        }
    }
}

/// Returns `f` of the values of two tensors of the same shape.
fn map(a: &FloatTensor<Flex>, b: &FloatTensor<Flex>, f: impl Fn(f32, f32) -> f32 + Copy + Sync) -> FloatTensor<Flex> {
    let shape = a.shape();
    let [a, b] = [a, b].map(|tensor| tensor.to_contiguous());
    let [a, b]: [&[f32]; 2] = [&a, &b].map(|tensor| tensor.as_slice().expect("f32"));
    let mut y = vec![0.0; a.len()];
    #[cfg(not(target_arch = "wasm32"))]
    if y.len() > CHUNK {
        let chunks = y.par_chunks_mut(CHUNK).zip(a.par_chunks(CHUNK)).zip(b.par_chunks(CHUNK));
        chunks.for_each(|((y, a), b)| vectorize(16, Map { a, b, y, f }));
        return FloatTensor::<Flex>::from_data(TensorData::new(y, shape));
    }
    vectorize(16, Map { a, b, y: &mut y, f });
    FloatTensor::<Flex>::from_data(TensorData::new(y, shape))
}

struct Map<'a, F> {
    a: &'a [f32],
    b: &'a [f32],
    y: &'a mut [f32],
    f: F,
}

impl<F: Fn(f32, f32) -> f32> WithSimd for Map<'_, F> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for ((y, a), b) in self.y.iter_mut().zip(self.a).zip(self.b) {
            *y = (self.f)(*a, *b);
        }
    }
}

/// Returns 1 / (1 + e^-x), and e^-|x|.
#[inline(always)]
pub(crate) fn logistic_and_exp(x: f32) -> (f32, f32) {
    let exp = exp_of_negative(-x.abs());
    let of_abs = 1.0 / (1.0 + exp);
    (if x < 0.0 { exp * of_abs } else { of_abs }, exp)
}

/// Returns e to a power of at most 0, with a relative error of 2e-7; 0 below e^-87. NaN stays NaN.
#[inline(always)]
fn exp_of_negative(x: f32) -> f32 {
    /// ln 2 in two parts, the first with few enough bits that its multiples are exact (Cody and Waite 1980).
    const LN_2: [f32; 2] = [0.693_359_4, -2.121_944_4e-4];
    /// Adding this rounds a small number to a whole one, ties to even.
    const ROUND: f32 = 12_582_912.0;
    let exponent = x * std::f32::consts::LOG2_E;
    let is_tiny = exponent < -126.0;
    let exponent = if is_tiny { -126.0 } else { exponent };
    let whole = (exponent + ROUND) - ROUND;
    let x = if is_tiny { 0.0 } else { x - whole * LN_2[0] - whole * LN_2[1] };
    // The Taylor series, for |x| of at most ln(2) / 2.
    let series = 1.0 + x * (1.0 + x * (1.0 / 2.0 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x / 720.0)))));
    let power_of_two = f32::from_bits(((whole as i32 + 127) << 23) as u32);
    if is_tiny { 0.0 } else { series * power_of_two }
}

/// Replaces every x by ln(1 + e^x).
pub(crate) fn softplus(values: &mut [f32]) {
    vectorize(16, Softplus(values));
}

struct Softplus<'a>(&'a mut [f32]);

impl WithSimd for Softplus<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for x in self.0 {
            *x = if *x > 0.0 { *x } else { 0.0 } + ln_1p(logistic_and_exp(*x).1);
        }
    }
}

/// Returns ln(1 + x) for x in 0..=1, with a relative error of 3e-7.
#[inline(always)]
pub(crate) fn ln_1p(x: f32) -> f32 {
    // 2 artanh(x / (2 + x)): a series in a square of at most 1/9.
    let ratio = x / (2.0 + x);
    let square = ratio * ratio;
    let tail = square
        * (1.0 / 3.0
            + square
                * (1.0 / 5.0 + square * (1.0 / 7.0 + square * (1.0 / 9.0 + square * (1.0 / 11.0 + square / 13.0)))));
    2.0 * ratio * (1.0 + tail)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_of_the_library() {
        let device = crate::nets::flex();
        let x: Vec<f32> = (-8000..=8000).map(|step| 0.0125 * step as f32).chain([-1e4, 1e4]).collect();
        let y = logistic(Tensor::<1>::from_data(TensorData::new(x.clone(), [x.len()]), &device)).into_data();
        for (&x, &y) in x.iter().zip(y.as_slice::<f32>().expect("f32")) {
            let expected = 1.0 / (1.0 + (-f64::from(x)).exp());
            assert!((f64::from(y) - expected).abs() <= 4e-7 * expected + 1e-37, "{x}: {y}, not {expected}");
        }
        let nan = logistic(Tensor::<1>::from_floats([f32::NAN], &device)).into_scalar::<f32>();
        assert!(nan.is_nan(), "damaged weights stay noticeable");
    }

    #[cfg(feature = "training")]
    #[test]
    fn the_gradient_is_the_slope() {
        let x = Tensor::<1>::from_floats([-20.0, -1.0, 0.0, 3.0], &crate::nets::flex().autodiff()).require_grad();
        let gradient = x.grad(&(logistic(x.clone()) * 2.0).sum().backward()).expect("a gradient").into_data();
        for (x, &slope) in [-20.0_f64, -1.0, 0.0, 3.0].into_iter().zip(gradient.as_slice::<f32>().expect("f32")) {
            let y = 1.0 / (1.0 + (-x).exp());
            let expected = 2.0 * y * (1.0 - y);
            assert!((f64::from(slope) - expected).abs() < 1e-6 * expected, "{x}: {slope}, not {expected}");
        }
    }

    #[test]
    fn the_logarithm_is_that_of_the_library() {
        for step in 0..=8000 {
            let x = step as f32 / 8000.0;
            let (found, expected) = (f64::from(ln_1p(x)), f64::from(x).ln_1p());
            assert!((found - expected).abs() <= 3e-7 * expected, "ln(1 + {x}): {found}, not {expected}");
        }
    }
}
