//! The mean binary cross-entropy of logits, in one pass forward and none backward.
//!
//! burn's formula is a dozen tensor operations on one core, each of which reads and writes all values. Here, one pass
//! over chunks, on all cores, computes the loss and its gradient. burn's formula defines the result: it is the default
//! body, which ndarray runs.

// burn has deprecated its ndarray backend; it is kept as the reference backend of the differential tests.
#![allow(deprecated)]

use burn::backend::autodiff::checkpoint::base::Checkpointer;
use burn::backend::autodiff::checkpoint::strategy::CheckpointStrategy;
use burn::backend::autodiff::grads::Gradients;
use burn::backend::autodiff::ops::{Backward, Ops, OpsKind};
use burn::backend::ops::FloatTensorOps;
use burn::backend::tensor::FloatTensor;
use burn::backend::{Autodiff, Backend, Dispatch, Flex, backend_extension};
use burn::tensor::{Tensor, TensorData};
use pulp::{Simd, WithSimd};
use rayon::prelude::*;

use crate::nets::conv::simd::vectorize;
use crate::nets::logistic::{CHUNK, ln_1p, logistic_and_exp};

/// Number of parallel sums, so that no addition waits for the previous one.
const LANES: usize = 16;

/// Returns the mean binary cross-entropy, `[1]`, between the sigmoid of logits and targets in 0..=1 of the same shape.
pub(crate) fn binary_cross_entropy_with_logits<const D: usize>(logits: Tensor<D>, targets: Tensor<D>) -> Tensor<1> {
    let [logits, targets] = [logits, targets].map(|tensor| tensor.flatten::<1>(0, D - 1).into_dispatch());
    Tensor::from_dispatch(Dispatch::binary_cross_entropy(logits, targets))
}

/// The loss on the tensors of a backend.
#[backend_extension(Flex, NdArray: cfg(feature = "ndarray"), Autodiff: cfg(feature = "training"))]
pub(crate) trait CrossEntropy: Backend {
    /// Returns the loss `[1]` of logits `[n]` and targets `[n]`. Targets get no gradient.
    fn binary_cross_entropy(logits: FloatTensor<Self>, targets: FloatTensor<Self>) -> FloatTensor<Self> {
        // softplus(x) = ln(1 + e^x), written so that no x overflows.
        let falling = Self::float_exp(Self::float_neg(Self::float_abs(logits.clone())));
        let softplus = Self::float_add(Self::relu(logits.clone()), Self::float_log1p(falling));
        Self::float_mean(Self::float_sub(softplus, Self::float_mul(logits, targets)))
    }
}

#[cfg(feature = "ndarray")]
impl CrossEntropy for burn::backend::NdArray {}

#[cfg(feature = "ndarray")]
impl<C: CheckpointStrategy> CrossEntropy for Autodiff<burn::backend::NdArray, C> {}

impl CrossEntropy for Flex {
    fn binary_cross_entropy(logits: FloatTensor<Flex>, targets: FloatTensor<Flex>) -> FloatTensor<Flex> {
        loss_and_gradient(logits, targets).0
    }
}

impl<C: CheckpointStrategy> CrossEntropy for Autodiff<Flex, C> {
    fn binary_cross_entropy(logits: FloatTensor<Self>, targets: FloatTensor<Self>) -> FloatTensor<Self> {
        let (loss, gradient) = loss_and_gradient(logits.primitive().clone(), targets.primitive().clone());
        match MeanCrossEntropy.prepare::<C>([logits.node()]).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish(gradient, loss),
            OpsKind::UnTracked(step) => step.finish(loss),
        }
    }
}

#[derive(Debug)]
struct MeanCrossEntropy;

impl Backward<Flex, 1> for MeanCrossEntropy {
    /// The gradient with respect to the logits.
    type State = FloatTensor<Flex>;

    fn backward(self, ops: Ops<FloatTensor<Flex>, 1>, store: &mut Gradients, _: &mut Checkpointer) {
        let of_loss = store.consume::<Flex>(&ops.node); // [1]
        if let [Some(logits)] = ops.parents {
            store.register::<Flex>(logits.id, Flex::float_mul(ops.state, of_loss));
        }
    }
}

/// Returns the loss, `[1]`, and its gradient with respect to the logits, `[n]`.
fn loss_and_gradient(logits: FloatTensor<Flex>, targets: FloatTensor<Flex>) -> (FloatTensor<Flex>, FloatTensor<Flex>) {
    let [logits, targets] = [logits, targets].map(|tensor| tensor.to_contiguous());
    let [logits, targets]: [&[f32]; 2] = [&logits, &targets].map(|tensor| tensor.as_slice().expect("f32"));
    let mut gradient = vec![0.0; logits.len()];
    let scale = 1.0 / logits.len() as f32;
    let chunks = gradient.par_chunks_mut(CHUNK).zip(logits.par_chunks(CHUNK)).zip(targets.par_chunks(CHUNK));
    // In the order of the chunks, so that the sum does not depend on the number of cores.
    let sums: Vec<f32> = chunks
        .map(|((gradient, logits), targets)| vectorize(LANES, OfChunk { logits, targets, gradient, scale }))
        .collect();
    let loss = sums.iter().map(|&sum| f64::from(sum)).sum::<f64>() * f64::from(scale);
    let tensor = |values: Vec<f32>| {
        let len = values.len();
        FloatTensor::<Flex>::from_data(TensorData::new(values, [len]))
    };
    (tensor(vec![loss as f32]), tensor(gradient))
}

/// Computes the gradient of a chunk and the sum of its losses.
struct OfChunk<'a> {
    logits: &'a [f32],
    targets: &'a [f32],
    gradient: &'a mut [f32],
    scale: f32,
}

impl WithSimd for OfChunk<'_> {
    type Output = f32;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> f32 {
        let OfChunk { logits, targets, gradient, scale } = self;
        let mut sums = [0.0; LANES];
        let values = logits.chunks(LANES).zip(targets.chunks(LANES)).zip(gradient.chunks_mut(LANES));
        for ((logits, targets), gradient) in values {
            for (((logit, target), gradient), sum) in logits.iter().zip(targets).zip(gradient).zip(&mut sums) {
                let (probability, exp) = logistic_and_exp(*logit);
                *gradient = (probability - target) * scale;
                *sum += if *logit > 0.0 { *logit } else { 0.0 } + ln_1p(exp) - logit * target;
            }
        }
        sums.iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use burn::tensor::Device;

    use super::*;

    const LOGITS: [f32; 8] = [0.0, 2.0, -3.0, 100.0, -100.0, 1e-3, -86.0, 15.0];
    const TARGETS: [f32; 8] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.3, 0.0, 1.0];

    #[test]
    fn the_loss_is_the_binary_cross_entropy_and_the_gradient_its_slope() {
        let device = crate::nets::flex().autodiff();
        // More than one chunk, and not a whole number of lanes.
        let count = CHUNK + 1237;
        let repeat = |values: [f32; 8]| (0..count).map(|index| values[index % 8]).collect::<Vec<_>>();
        let tensor = |values: [f32; 8], device: &Device| {
            Tensor::<1>::from_data(TensorData::new(repeat(values), [count]), device)
        };
        let logits = tensor(LOGITS, &device).require_grad();
        let loss = binary_cross_entropy_with_logits(logits.clone(), tensor(TARGETS, &device));
        let gradient = logits.grad(&(loss.clone() * 3.0).backward()).expect("a gradient").into_data();
        let mut expected = 0.0;
        for (index, &slope) in gradient.as_slice::<f32>().expect("f32").iter().enumerate() {
            let (logit, target) = (f64::from(LOGITS[index % 8]), f64::from(TARGETS[index % 8]));
            let softplus = logit.max(0.0) + (-logit.abs()).exp().ln_1p();
            expected += softplus - logit * target;
            let of_mean = 3.0 * (1.0 / (1.0 + (-logit).exp()) - target) / count as f64;
            assert!((f64::from(slope) - of_mean).abs() < 1e-6 * 3.0 / count as f64, "{logit}: {slope}, not {of_mean}");
        }
        expected /= count as f64;
        let loss = f64::from(loss.into_scalar::<f32>());
        assert!((loss - expected).abs() < 1e-6 * expected, "{loss}, not {expected}");
    }

    #[cfg(feature = "ndarray")]
    #[test]
    fn ndarray_computes_the_same_loss() {
        let loss = |device: Device| {
            let [logits, targets] = [LOGITS, TARGETS].map(|values| Tensor::<1>::from_floats(values, &device));
            binary_cross_entropy_with_logits(logits, targets).into_scalar::<f32>()
        };
        let [ours, burns] = [crate::nets::flex(), Device::ndarray()].map(loss);
        assert!((ours - burns).abs() < 1e-6 * burns, "{ours}, not {burns}");
    }
}
