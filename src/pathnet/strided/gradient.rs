//! The gradients of the two operations, and how burn's autodiff learns of them.
//!
//! With `c` the gathered patches of the wide picture and `w` the weights, halving is `w c` and doubling scatters
//! `w' x`; so each one's gradient by its input is the other without its bias, and the gradient by the weights is
//! the product of the narrow side and the patches. Native only: the page does not train.

use burn::backend::autodiff::NodeId;
use burn::backend::autodiff::checkpoint::base::Checkpointer;
use burn::backend::autodiff::checkpoint::strategy::CheckpointStrategy;
use burn::backend::autodiff::grads::Gradients;
use burn::backend::autodiff::ops::{Backward, Ops, OpsKind};
use burn::backend::tensor::FloatTensor;
use burn::backend::{Autodiff, Flex, TensorMetadata};
use burn::tensor::TensorData;
use std::sync::Mutex;

use super::layer::{Columns, Group, Layer};
use super::product::{Matrix, product};
use super::{StridedOps, geometry, numbers};

/// What the input, the weights and the bias of a layer would have to change by.
struct Slopes {
    x: Vec<f32>,
    weight: Vec<f32>,
    bias: Vec<f32>,
}

impl Layer<'_> {
    /// Of `halve`: from its input, its output and the slope of its output.
    fn halve_back(&self, x: &[f32], y: &[f32], slope: &[f32]) -> Slopes {
        let geometry = self.geometry;
        let cells = geometry.cells();
        let mut dx = vec![0.0; x.len()];
        let (weight, bias) = self.summed(&mut dx, geometry.wide_picture(), |group, dx, part| {
            let range = group.narrow(&geometry);
            let passed = passed(&slope[range.clone()], Some(&y[range]));
            add_channels(&mut part.bias, &passed, cells);
            let passed = self.channels_first(&passed, group.samples);
            let mut columns = Columns::gathered(&geometry, &x[group.wide(&geometry)], group.samples);
            let passed = Matrix::new(&passed, geometry.narrow, columns.count, columns.count);
            product(&mut part.weight, geometry.patch(), passed, columns.matrix(&geometry).transposed(), false);
            product(&mut columns.data, columns.stride, self.matrix().transposed(), passed, false);
            columns.scatter(&geometry, dx);
        }, geometry.narrow);
        Slopes { x: dx, weight, bias }
    }

    /// Of `double`: from its input, its output (where that is cut off below zero) and the slope of its output.
    fn double_back(&self, x: &[f32], y: Option<&[f32]>, slope: &[f32]) -> Slopes {
        let geometry = self.geometry;
        let cells = geometry.cells();
        let mut dx = vec![0.0; x.len()];
        let (weight, bias) = self.summed(&mut dx, geometry.narrow_picture(), |group, dx, part| {
            let range = group.wide(&geometry);
            let passed = passed(&slope[range.clone()], y.map(|y| &y[range]));
            add_channels(&mut part.bias, &passed, geometry.wide_cells());
            let columns = Columns::gathered(&geometry, &passed, group.samples);
            let x = self.channels_first(&x[group.narrow(&geometry)], group.samples);
            let x = Matrix::new(&x, geometry.narrow, columns.count, columns.count);
            product(&mut part.weight, geometry.patch(), x, columns.matrix(&geometry).transposed(), false);
            let mut sums = vec![0.0; dx.len()];
            product(&mut sums, columns.count, self.matrix(), columns.matrix(&geometry), false);
            for (index, dx) in dx.chunks_exact_mut(cells).enumerate() {
                let (sample, channel) = (index / geometry.narrow, index % geometry.narrow);
                dx.copy_from_slice(&sums[channel * columns.count + sample * cells..][..cells]);
            }
        }, geometry.wide);
        Slopes { x: dx, weight, bias }
    }

    /// Calls `work` for every group, and sums up the parts that the groups give, in their order, so that the
    /// result does not hang on the number of cores.
    fn summed(
        &self,
        out: &mut [f32],
        size: usize,
        work: impl Fn(Group, &mut [f32], &mut Part) + Sync,
        channels: usize,
    ) -> (Vec<f32>, Vec<f32>) {
        let parts = Mutex::new(Vec::new());
        self.each_group(out, size, |group, out| {
            let mut part = Part { weight: vec![0.0; self.weight.len()], bias: vec![0.0; channels] };
            work(group, out, &mut part);
            parts.lock().expect("no group panics").push((group.first, part));
        });
        let mut parts = parts.into_inner().expect("no group panics");
        parts.sort_by_key(|(first, _)| *first);
        let mut parts = parts.into_iter().map(|(_, part)| part);
        let Part { mut weight, mut bias } = parts.next().expect("a batch has samples");
        for part in parts {
            weight.iter_mut().zip(part.weight).for_each(|(sum, one)| *sum += one);
            bias.iter_mut().zip(part.bias).for_each(|(sum, one)| *sum += one);
        }
        (weight, bias)
    }
}

/// The slopes that one group gives.
struct Part {
    weight: Vec<f32>,
    bias: Vec<f32>,
}

/// The slope that passes the relu: where the output is zero, none.
fn passed(slope: &[f32], y: Option<&[f32]>) -> Vec<f32> {
    match y {
        Some(y) => slope.iter().zip(y).map(|(slope, y)| if *y > 0.0 { *slope } else { 0.0 }).collect(),
        None => slope.to_vec(),
    }
}

/// Adds the sum of every channel of some samples.
fn add_channels(sums: &mut [f32], pictures: &[f32], cells: usize) {
    let channels = sums.len();
    for (index, plane) in pictures.chunks_exact(cells).enumerate() {
        sums[index % channels] += plane.iter().sum::<f32>();
    }
}

#[derive(Debug)]
struct Halve;

#[derive(Debug)]
struct Double {
    positive: bool,
}

/// Input, weights and output of a layer.
type Kept = [FloatTensor<Flex>; 3];

impl Backward<Flex, 3> for Halve {
    type State = Kept;

    fn backward(self, ops: Ops<Kept, 3>, grads: &mut Gradients, _: &mut Checkpointer) {
        let slope = grads.consume::<Flex>(&ops.node);
        let [x, weight, y] = &ops.state;
        let geometry = geometry(weight, y.shape()[2]);
        let slopes = numbers(weight, |weight| {
            numbers(x, |x| numbers(y, |y| numbers(&slope, |slope| Layer { geometry, weight }.halve_back(x, y, slope))))
        });
        register(ops.parents.map(|parent| parent.map(|node| node.id)), &ops.state, slopes, grads);
    }
}

impl Backward<Flex, 3> for Double {
    type State = Kept;

    fn backward(self, ops: Ops<Kept, 3>, grads: &mut Gradients, _: &mut Checkpointer) {
        let slope = grads.consume::<Flex>(&ops.node);
        let [x, weight, y] = &ops.state;
        let geometry = geometry(weight, x.shape()[2]);
        let slopes = numbers(weight, |weight| {
            numbers(x, |x| {
                numbers(y, |y| {
                    let y = self.positive.then_some(y);
                    numbers(&slope, |slope| Layer { geometry, weight }.double_back(x, y, slope))
                })
            })
        });
        register(ops.parents.map(|parent| parent.map(|node| node.id)), &ops.state, slopes, grads);
    }
}

/// Hands the slopes to those of the three parents that ask for them.
fn register(parents: [Option<NodeId>; 3], [x, weight, _]: &Kept, slopes: Slopes, grads: &mut Gradients) {
    let shaped = |numbers: Vec<f32>, shape: &FloatTensor<Flex>| {
        FloatTensor::<Flex>::from_data(TensorData::new(numbers, shape.shape()))
    };
    let [for_x, for_weight, for_bias] = parents;
    if let Some(id) = for_x {
        grads.register::<Flex>(id, shaped(slopes.x, x));
    }
    if let Some(id) = for_weight {
        grads.register::<Flex>(id, shaped(slopes.weight, weight));
    }
    if let Some(id) = for_bias {
        let channels = slopes.bias.len();
        grads.register::<Flex>(id, FloatTensor::<Flex>::from_data(TensorData::new(slopes.bias, [channels])));
    }
}

impl<C: CheckpointStrategy> StridedOps for Autodiff<Flex, C> {
    fn halve(x: FloatTensor<Self>, weight: FloatTensor<Self>, bias: FloatTensor<Self>) -> FloatTensor<Self> {
        let y = Flex::halve(x.primitive().clone(), weight.primitive().clone(), bias.primitive().clone());
        let nodes = [x.node(), weight.node(), bias.node()];
        match Halve.prepare::<C>(nodes).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish([x.primitive().clone(), weight.primitive().clone(), y.clone()], y),
            OpsKind::UnTracked(step) => step.finish(y),
        }
    }

    fn double(
        x: FloatTensor<Self>,
        weight: FloatTensor<Self>,
        bias: FloatTensor<Self>,
        positive: bool,
    ) -> FloatTensor<Self> {
        let y = Flex::double(x.primitive().clone(), weight.primitive().clone(), bias.primitive().clone(), positive);
        let nodes = [x.node(), weight.node(), bias.node()];
        match (Double { positive }).prepare::<C>(nodes).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish([x.primitive().clone(), weight.primitive().clone(), y.clone()], y),
            OpsKind::UnTracked(step) => step.finish(y),
        }
    }
}

/// On ndarray burn differentiates its own operations: the second opinion.
#[cfg(feature = "ndarray")]
impl<C: CheckpointStrategy> StridedOps for Autodiff<burn::backend::NdArray, C> {}
