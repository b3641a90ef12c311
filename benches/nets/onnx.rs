//! The nets as ONNX graphs, wired as in `src/nets`, for other engines to run. `lab/tests/onnx.rs` checks that the
//! graphs compute the same values.
//!
//! Contains only the messages and fields of onnx.proto that the graphs need, with the schema's tags and names.

use std::collections::BTreeMap;

use pathlight::nets::success_net::RADII;
use pathlight::nets::{Parameter, PathNet};
use pathlight::raster::{CHANNELS, SIDE};
use prost::Message;

/// `TensorProto.DataType` and `AttributeProto.AttributeType`.
const FLOAT: i32 = 1;
const INT64: i32 = 7;
const INT: i32 = 2;
const INTS: i32 = 7;

/// Versions that every engine supports.
const OPERATORS: i64 = 13;
const IR: i64 = 8;

#[derive(Message)]
pub struct Model {
    #[prost(int64, optional, tag = "1")]
    ir_version: Option<i64>,
    #[prost(message, optional, tag = "7")]
    pub graph: Option<Graph>,
    #[prost(message, repeated, tag = "8")]
    opset_import: Vec<OperatorSet>,
}

#[derive(Message)]
struct OperatorSet {
    #[prost(int64, optional, tag = "2")]
    version: Option<i64>,
}

#[derive(Clone, Message)]
pub struct Graph {
    #[prost(message, repeated, tag = "1")]
    pub node: Vec<Node>,
    #[prost(string, optional, tag = "2")]
    name: Option<String>,
    #[prost(message, repeated, tag = "5")]
    pub initializer: Vec<Tensor>,
    #[prost(message, repeated, tag = "11")]
    pub input: Vec<ValueInfo>,
    #[prost(message, repeated, tag = "12")]
    pub output: Vec<ValueInfo>,
}

#[derive(Clone, Message)]
pub struct Node {
    #[prost(string, repeated, tag = "1")]
    pub input: Vec<String>,
    #[prost(string, repeated, tag = "2")]
    pub output: Vec<String>,
    #[prost(string, optional, tag = "3")]
    name: Option<String>,
    #[prost(string, optional, tag = "4")]
    op_type: Option<String>,
    #[prost(message, repeated, tag = "5")]
    pub attribute: Vec<Attribute>,
}

#[derive(Clone, Message)]
pub struct Attribute {
    #[prost(string, optional, tag = "1")]
    name: Option<String>,
    #[prost(int64, optional, tag = "3")]
    pub i: Option<i64>,
    #[prost(int64, repeated, packed = "false", tag = "8")]
    pub ints: Vec<i64>,
    #[prost(int32, optional, tag = "20")]
    r#type: Option<i32>,
}

#[derive(Clone, Message)]
pub struct Tensor {
    #[prost(int64, repeated, packed = "false", tag = "1")]
    pub dims: Vec<i64>,
    #[prost(int32, optional, tag = "2")]
    data_type: Option<i32>,
    #[prost(string, optional, tag = "8")]
    name: Option<String>,
    #[prost(bytes = "vec", optional, tag = "9")]
    raw_data: Option<Vec<u8>>,
}

#[derive(Clone, Message)]
pub struct ValueInfo {
    #[prost(string, optional, tag = "1")]
    name: Option<String>,
    #[prost(message, optional, tag = "2")]
    r#type: Option<Type>,
}

#[derive(Clone, Message)]
struct Type {
    #[prost(message, optional, tag = "1")]
    tensor_type: Option<TensorType>,
}

#[derive(Clone, Message)]
struct TensorType {
    #[prost(int32, optional, tag = "1")]
    elem_type: Option<i32>,
    #[prost(message, optional, tag = "2")]
    shape: Option<Shape>,
}

#[derive(Clone, Message)]
struct Shape {
    #[prost(message, repeated, tag = "1")]
    dim: Vec<Dimension>,
}

#[derive(Clone, Message)]
struct Dimension {
    #[prost(int64, optional, tag = "1")]
    dim_value: Option<i64>,
}

/// Returns the graph of the paper's four nets. Input: the scene's set cells `scene` `[1, 5, 64, 64]`. Outputs: the maps
/// base, target, action and placement, each `[1, 1, 64, 64]` after its sigmoid.
pub fn four_nets(nets: &PathNet) -> Vec<u8> {
    let mut builder = Builder::new(nets);
    let maps = builder.maps();
    builder.file(&["scene"], maps)
}

/// Returns the graph of all nets. It has a second input, the covered shares of the scene's cells, `coverage`
/// `[1, 5, 64, 64]`, and another output, the logits of the cells, `[1, 8, 64, 64]`, averaged over the scene and its
/// mirror image.
pub fn all_nets(nets: &PathNet) -> Vec<u8> {
    let mut builder = Builder::new(nets);
    let mut outputs = builder.maps();
    outputs.push(builder.cell_logits());
    builder.file(&["scene", "coverage"], outputs)
}

/// An output of a graph and its channels.
type Output = (String, usize);

struct Builder {
    nodes: Vec<Node>,
    parameters: BTreeMap<String, Parameter>,
    constants: Vec<Tensor>,
}

impl Builder {
    fn new(nets: &PathNet) -> Builder {
        Builder { nodes: Vec::new(), parameters: nets.parameters(), constants: Vec::new() }
    }

    /// Adds a node and returns the name of its output.
    fn add(&mut self, operator: &str, inputs: &[&str], output: &str, attributes: Vec<Attribute>) -> String {
        self.nodes.push(Node {
            input: inputs.iter().map(|input| input.to_string()).collect(),
            output: vec![output.to_string()],
            name: Some(output.to_string()),
            op_type: Some(operator.to_string()),
            attribute: attributes,
        });
        output.to_string()
    }

    fn concat(&mut self, inputs: &[&str], output: &str, axis: i64) -> String {
        self.add("Concat", inputs, output, vec![int("axis", axis)])
    }

    /// Adds a layer: a convolution in the `down` half, otherwise a transposed convolution.
    fn layer(&mut self, name: &str, x: &str, relu: bool) -> String {
        let operator = if name.contains(".down.") { "Conv" } else { "ConvTranspose" };
        let (weight, bias) = (format!("{name}.weight"), format!("{name}.bias"));
        let kernel = *self.parameters[&weight].shape.last().expect("a kernel") as i64;
        let padding = (kernel - 2) / 2;
        let attributes =
            vec![ints("kernel_shape", &[kernel; 2]), ints("pads", &[padding; 4]), ints("strides", &[2, 2])];
        let y = self.add(operator, &[x, &weight, &bias], name, attributes);
        if relu { self.add("Relu", &[&y], &format!("{name}.relu"), vec![]) } else { y }
    }

    /// Adds one of the four nets and returns the name of its map.
    fn hourglass(&mut self, net: &str, images: &str) -> String {
        let mut x = images.to_string();
        for (half, relu_after_last) in [("down", true), ("up", false)] {
            for layer in 0..6 {
                x = self.layer(&format!("{net}.{half}.{layer}"), &x, layer < 5 || relu_after_last);
            }
        }
        self.add("Sigmoid", &[&x], net, vec![])
    }

    fn maps(&mut self) -> Vec<Output> {
        let base = self.hourglass("base", "scene");
        let target = self.hourglass("target", "scene");
        let seen = self.concat(&["scene", &target], "seen", 1);
        let images = self.concat(&[&seen, &base], "seen.base", 1);
        let action = self.hourglass("action", &images);
        let images = self.concat(&[&seen, &action], "seen.action", 1);
        let placement = self.hourglass("placement", &images);
        [base, target, action, placement].map(|map| (map, 1)).into()
    }

    fn mirror(&mut self, x: &str, output: &str) -> String {
        self.add("Gather", &[x, "columns"], output, vec![int("axis", 3)])
    }

    /// Adds the U-Net of the dynamics net. Each decoder layer except the first also receives the encoder output of the
    /// same size.
    fn cell_logits(&mut self) -> Output {
        const LAYERS: usize = 5;
        // The other channels of the last layer are features of balls.
        let last = format!("dynamics.up.{}", LAYERS - 1);
        let weight = self.parameters.get_mut(&format!("{last}.weight")).expect("a dynamics net");
        let [_, channels, height, width] = weight.shape[..] else { panic!("four dimensions") };
        let kept = weight.values.chunks(channels * height * width).flat_map(|input| &input[..RADII * height * width]);
        weight.values = kept.copied().collect();
        weight.shape[1] = RADII;
        let bias = self.parameters.get_mut(&format!("{last}.bias")).expect("a bias");
        bias.values.truncate(RADII);
        bias.shape[0] = RADII;
        let columns = (0..SIDE as i64).rev().flat_map(i64::to_le_bytes).collect();
        self.constants.push(tensor("columns", INT64, &[SIDE], columns));
        self.constants.push(tensor("halves", INT64, &[2], [1_i64; 2].into_iter().flat_map(i64::to_le_bytes).collect()));
        self.constants.push(tensor("two", FLOAT, &[], 2_f32.to_le_bytes().into()));

        let mirrored = self.mirror("coverage", "mirrored.coverage");
        let mut x = self.concat(&["coverage", &mirrored], "both", 0);
        let mut encoded = Vec::new();
        for layer in 0..LAYERS {
            x = self.layer(&format!("dynamics.down.{layer}"), &x, true);
            encoded.push(x.clone());
        }
        encoded.pop();
        for layer in 0..LAYERS {
            x = self.layer(&format!("dynamics.up.{layer}"), &x, layer < LAYERS - 1);
            if let Some(skip) = encoded.pop() {
                x = self.concat(&[&x, &skip], &format!("dynamics.up.{layer}.skip"), 1);
            }
        }
        self.add("Split", &[&x, "halves"], "straight", vec![int("axis", 0)]);
        self.nodes.last_mut().expect("a node").output.push("mirrored".to_string());
        let mirrored = self.mirror("mirrored", "unmirrored");
        let sum = self.add("Add", &["straight", &mirrored], "sum", vec![]);
        (self.add("Div", &[&sum, "two"], "cells", vec![]), RADII)
    }

    /// Returns the bytes of the file.
    fn file(self, inputs: &[&str], outputs: Vec<Output>) -> Vec<u8> {
        let Builder { nodes, parameters, constants } = self;
        let is_used = |name: &String| nodes.iter().any(|node| node.input.contains(name));
        let weights = parameters.iter().filter(|(name, _)| is_used(name)).map(|(name, Parameter { shape, values })| {
            tensor(name, FLOAT, shape, values.iter().flat_map(|value| value.to_le_bytes()).collect())
        });
        let graph = Graph {
            name: Some("pathlight".to_string()),
            initializer: weights.chain(constants).collect(),
            input: inputs.iter().map(|name| images(name, CHANNELS)).collect(),
            output: outputs.iter().map(|(name, channels)| images(name, *channels)).collect(),
            node: nodes,
        };
        let opset_import = vec![OperatorSet { version: Some(OPERATORS) }];
        Model { ir_version: Some(IR), graph: Some(graph), opset_import }.encode_to_vec()
    }
}

fn int(name: &str, value: i64) -> Attribute {
    Attribute { name: Some(name.to_string()), i: Some(value), ints: vec![], r#type: Some(INT) }
}

fn ints(name: &str, values: &[i64]) -> Attribute {
    Attribute { name: Some(name.to_string()), i: None, ints: values.into(), r#type: Some(INTS) }
}

fn tensor(name: &str, data_type: i32, shape: &[usize], bytes: Vec<u8>) -> Tensor {
    Tensor {
        dims: shape.iter().map(|&size| size as i64).collect(),
        data_type: Some(data_type),
        name: Some(name.to_string()),
        raw_data: Some(bytes),
    }
}

/// The declaration of an image `[1, channels, 64, 64]`.
fn images(name: &str, channels: usize) -> ValueInfo {
    let dim = [1, channels, SIDE, SIDE].map(|size| Dimension { dim_value: Some(size as i64) }).into();
    let tensor_type = TensorType { elem_type: Some(FLOAT), shape: Some(Shape { dim }) };
    ValueInfo { name: Some(name.to_string()), r#type: Some(Type { tensor_type: Some(tensor_type) }) }
}
