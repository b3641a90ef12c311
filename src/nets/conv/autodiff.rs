//! Both layers in burn's autodiff: the tensors that the forward pass saves, and the gradients. Native only.

use burn::backend::autodiff::NodeId;
use burn::backend::autodiff::checkpoint::base::Checkpointer;
use burn::backend::autodiff::checkpoint::strategy::CheckpointStrategy;
use burn::backend::autodiff::grads::Gradients as GradientStore;
use burn::backend::autodiff::ops::{Backward, Ops, OpsKind};
use burn::backend::tensor::FloatTensor;
use burn::backend::{Autodiff, Flex, TensorMetadata};
use burn::tensor::TensorData;

use super::backward::Gradients;
use super::forward::Layer;
use super::{StridedConv, flex_conv_down, flex_conv_up, geometry, slice};

#[derive(Debug)]
struct ConvDown;

#[derive(Debug)]
struct ConvUp {
    relu: bool,
}

/// The tensors of the forward pass that the backward pass needs: input, weights and output of a layer.
type SavedTensors = [FloatTensor<Flex>; 3];

impl Backward<Flex, 3> for ConvDown {
    type State = SavedTensors;

    fn backward(self, ops: Ops<SavedTensors, 3>, store: &mut GradientStore, _: &mut Checkpointer) {
        let dy = store.consume::<Flex>(&ops.node).to_contiguous();
        let [x, weight, y] = ops.state.each_ref().map(|tensor| tensor.to_contiguous());
        let layer = Layer { geometry: geometry(&weight, y.shape()[2]), weight: slice(&weight), fused: true };
        let gradients = layer.conv_down_backward(slice(&x), slice(&y), slice(&dy), ops.parents[0].is_some());
        register(ops.parents.map(|parent| parent.map(|node| node.id)), &ops.state, gradients, store);
    }
}

impl Backward<Flex, 3> for ConvUp {
    type State = SavedTensors;

    fn backward(self, ops: Ops<SavedTensors, 3>, store: &mut GradientStore, _: &mut Checkpointer) {
        let dy = store.consume::<Flex>(&ops.node).to_contiguous();
        let [x, weight, y] = ops.state.each_ref().map(|tensor| tensor.to_contiguous());
        let layer = Layer { geometry: geometry(&weight, x.shape()[2]), weight: slice(&weight), fused: true };
        let gradients = layer.conv_up_backward(slice(&x), self.relu.then_some(slice(&y)), slice(&dy));
        register(ops.parents.map(|parent| parent.map(|node| node.id)), &ops.state, gradients, store);
    }
}

/// Registers the gradients of input, weights and bias, if they are needed.
fn register(
    parents: [Option<NodeId>; 3],
    [x, weight, _]: &SavedTensors,
    gradients: Gradients,
    store: &mut GradientStore,
) {
    let bias_shape = [gradients.bias.len()].into();
    let values = [(gradients.x, x.shape()), (gradients.weight, weight.shape()), (gradients.bias, bias_shape)];
    for (parent, (values, shape)) in parents.into_iter().zip(values) {
        if let Some(id) = parent {
            store.register::<Flex>(id, FloatTensor::<Flex>::from_data(TensorData::new(values, shape)));
        }
    }
}

impl<C: CheckpointStrategy> StridedConv for Autodiff<Flex, C> {
    fn conv_down(x: FloatTensor<Self>, weight: FloatTensor<Self>, bias: FloatTensor<Self>) -> FloatTensor<Self> {
        let y = flex_conv_down(x.primitive().clone(), weight.primitive().clone(), bias.primitive().clone(), true);
        let nodes = [x.node(), weight.node(), bias.node()];
        match ConvDown.prepare::<C>(nodes).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish([x.primitive().clone(), weight.primitive().clone(), y.clone()], y),
            OpsKind::UnTracked(step) => step.finish(y),
        }
    }

    fn conv_up(
        x: FloatTensor<Self>,
        weight: FloatTensor<Self>,
        bias: FloatTensor<Self>,
        relu: bool,
    ) -> FloatTensor<Self> {
        let y = flex_conv_up(x.primitive().clone(), weight.primitive().clone(), bias.primitive().clone(), relu, true);
        let nodes = [x.node(), weight.node(), bias.node()];
        match (ConvUp { relu }).prepare::<C>(nodes).compute_bound().stateful() {
            OpsKind::Tracked(step) => step.finish([x.primitive().clone(), weight.primitive().clone(), y.clone()], y),
            OpsKind::UnTracked(step) => step.finish(y),
        }
    }
}

/// ndarray differentiates burn's own operations: the reference backend of the differential tests.
#[cfg(feature = "ndarray")]
impl<C: CheckpointStrategy> StridedConv for Autodiff<burn::backend::NdArray, C> {}
