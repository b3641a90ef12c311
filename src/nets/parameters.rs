//! The parameters of nets as plain numbers, by name: the path of each in its net, for example `base.down.0.weight`.
//!
//! Used for weights files, and by other engines that run the same nets.

use std::collections::BTreeMap;

use burn::module::{Module, ModuleVisitor, Param};
use burn::tensor::Tensor;

use super::PathNet;

/// A tensor of weights or biases.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The dimensions, outermost first.
    pub shape: Vec<usize>,
    /// The values, row-major.
    pub values: Vec<f32>,
}

impl PathNet {
    /// Returns all parameters by their names in weights files.
    pub fn parameters(&self) -> BTreeMap<String, Parameter> {
        parameters(self)
    }
}

/// Returns all parameters of nets.
pub(super) fn parameters(nets: &impl Module) -> BTreeMap<String, Parameter> {
    let mut collector = Collector::default();
    nets.visit(&mut collector);
    collector.parameters
}

#[derive(Default)]
struct Collector {
    path: Vec<String>,
    parameters: BTreeMap<String, Parameter>,
}

impl ModuleVisitor for Collector {
    fn enter_module(&mut self, name: &str, _: &str) {
        self.path.push(name.to_string());
    }

    fn exit_module(&mut self, _: &str, _: &str) {
        self.path.pop();
    }

    fn visit_float<const D: usize>(&mut self, param: &Param<Tensor<D>>) {
        let tensor = param.val();
        let shape = tensor.dims().to_vec();
        self.parameters.insert(self.path.join("."), Parameter { shape, values: tensor.into_data().iter().collect() });
    }
}
