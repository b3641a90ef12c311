//! The ONNX graphs that `make bench` runs in other engines compute the same as our nets: the test evaluates every node
//! with plain loops.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use onnx::{Graph, Model, Node};
use pathlight::nets::{Imagined, PathNet};
use pathlight::puzzle::task::Task;
use pathlight::raster::{Bitmap, CHANNELS, Coverage, SIDE, scene_channels, scene_coverage};
use prost::Message;

#[path = "../../benches/nets/onnx.rs"]
mod onnx;

/// An array of up to four dimensions.
#[derive(Clone)]
struct Array {
    shape: Vec<usize>,
    values: Vec<f32>,
}

#[test]
fn the_exported_graphs_compute_what_our_nets_compute() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for weights in ["within-0", "cross-0"] {
        let bytes = fs::read(root.join(format!("assets/{weights}.safetensors"))).expect("the shipped weights");
        let (nets, _) = PathNet::load(&bytes).expect("our own weights");
        for id in ["00007:008", "00012:002"] {
            let scene = Task::load(id.parse().expect("an id")).expect("a task").scene;
            let Imagined { base, target, action, placement } = nets.imagine(&scene);
            let cells = nets.cell_logits(&scene).expect("a dynamics net");
            let expected = [base, target, action, placement, cells];
            let image = |values: Vec<f32>| Array { shape: vec![1, CHANNELS, SIDE, SIDE], values };
            let set = image(scene_channels(&scene).iter().flat_map(Bitmap::to_f32).collect());
            let coverage = image(scene_coverage(&scene).iter().flat_map(Coverage::to_f32).collect());

            let four = evaluate(&onnx::four_nets(&nets), &[("scene", &set)]);
            let all = evaluate(&onnx::all_nets(&nets), &[("scene", &set), ("coverage", &coverage)]);
            assert_eq!((four.len(), all.len()), (4, 5));
            for (map, (found, expected)) in four.iter().zip(&expected).chain(all.iter().zip(&expected)).enumerate() {
                assert_eq!(found.values.len(), expected.len());
                let apart = found.values.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(apart < 1e-3, "{weights}, {id}: output {map} is {apart} from ours");
            }
        }
    }
}

/// The outputs of a graph.
fn evaluate(file: &[u8], inputs: &[(&str, &Array)]) -> Vec<Array> {
    let graph = Model::decode(file).expect("an ONNX file").graph.expect("a graph");
    let declared: Vec<&str> = graph.input.iter().map(|input| input.name()).collect();
    assert_eq!(declared, inputs.iter().map(|(name, _)| *name).collect::<Vec<_>>());
    let mut arrays: HashMap<String, Array> =
        inputs.iter().map(|(name, array)| (name.to_string(), (*array).clone())).collect();
    let Graph { node: nodes, initializer, output, .. } = graph;
    arrays.extend(initializer.iter().map(|tensor| {
        let shape: Vec<usize> = tensor.dims.iter().map(|&size| size as usize).collect();
        let count = shape.iter().product::<usize>();
        let values: Vec<f32> = match tensor.raw_data().len() / count {
            4 => tensor.raw_data().as_chunks().0.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect(),
            _ => tensor.raw_data().as_chunks().0.iter().map(|&bytes| i64::from_le_bytes(bytes) as f32).collect(),
        };
        assert_eq!(values.len(), count, "{}", tensor.name());
        (tensor.name().to_string(), Array { shape, values })
    }));
    for node in &nodes {
        let inputs: Vec<&Array> = node.input.iter().map(|name| &arrays[name]).collect();
        let results = run(node, &inputs);
        arrays.extend(node.output.iter().cloned().zip(results));
    }
    output.iter().map(|output| arrays[output.name()].clone()).collect()
}

fn run(node: &Node, inputs: &[&Array]) -> Vec<Array> {
    let attribute = |name: &str| node.attribute.iter().find(|attribute| attribute.name() == name);
    let axis = || attribute("axis").expect("an axis").i() as usize;
    let each = |of: &dyn Fn(f32) -> f32| {
        let Array { shape, values } = inputs[0];
        vec![Array { shape: shape.clone(), values: values.iter().map(|&value| of(value)).collect() }]
    };
    let pairs = |of: &dyn Fn(f32, f32) -> f32| {
        let [Array { shape, values }, other] = inputs else { panic!("two inputs") };
        let of_index = |index: usize| other.values[index % other.values.len()];
        let values = values.iter().enumerate().map(|(index, &value)| of(value, of_index(index))).collect();
        vec![Array { shape: shape.clone(), values }]
    };
    match node.op_type() {
        "Relu" => each(&|x| x.max(0.0)),
        "Sigmoid" => each(&|x| 1.0 / (1.0 + (-x).exp())),
        "Add" => pairs(&|a, b| a + b),
        "Div" => pairs(&|a, b| a / b),
        "Concat" => vec![concat(inputs, axis())],
        "Split" => split(inputs[0], &inputs[1].values, axis()),
        "Gather" => {
            let [Array { shape, values }, columns] = inputs else { panic!("two inputs") };
            assert_eq!(axis(), shape.len() - 1, "the last axis");
            let rows = values.chunks(*shape.last().expect("an axis"));
            let values = rows.flat_map(|row| columns.values.iter().map(|&column| row[column as usize])).collect();
            vec![Array { shape: shape.clone(), values }]
        }
        "Conv" | "ConvTranspose" => {
            let ints = |name: &str| attribute(name).expect("an attribute of convolutions").ints.clone();
            assert_eq!(ints("strides"), [2, 2]);
            let padding = ints("pads")[0] as usize;
            assert_eq!(ints("pads"), [padding as i64; 4]);
            assert_eq!(ints("kernel_shape"), inputs[1].shape[2..].iter().map(|&side| side as i64).collect::<Vec<_>>());
            vec![convolve(inputs, padding, node.op_type() == "ConvTranspose")]
        }
        other => panic!("no {other}"),
    }
}

fn concat(inputs: &[&Array], axis: usize) -> Array {
    let mut shape = inputs[0].shape.clone();
    shape[axis] = inputs.iter().map(|input| input.shape[axis]).sum();
    let outer: usize = shape[..axis].iter().product();
    let block = |input: &Array, index: usize| {
        let length = input.values.len() / outer;
        input.values[index * length..][..length].to_vec()
    };
    let values = (0..outer).flat_map(|index| inputs.iter().flat_map(move |input| block(input, index))).collect();
    Array { shape, values }
}

/// Splits the first axis.
fn split(input: &Array, sizes: &[f32], axis: usize) -> Vec<Array> {
    assert_eq!(axis, 0);
    let mut rest = &input.values[..];
    let mut part = |&size: &f32| {
        let mut shape = input.shape.clone();
        shape[0] = size as usize;
        let (values, after) = rest.split_at(shape.iter().product());
        rest = after;
        Array { shape, values: values.to_vec() }
    };
    sizes.iter().map(&mut part).collect()
}

/// A convolution of stride 2, or a transposed one: every coarse cell is combined with the fine cells under its kernel.
fn convolve(inputs: &[&Array], padding: usize, transposed: bool) -> Array {
    let [x, weight, bias] = inputs else { panic!("image, weight and bias") };
    let ([batch, channels, side, _], [_, fine_channels, kernel, _]) = (&x.shape[..], &weight.shape[..]) else {
        panic!("four dimensions")
    };
    let (outputs, out_side) = (bias.values.len(), if transposed { side * 2 } else { side / 2 });
    let (fine, coarse) = if transposed { (out_side, *side) } else { (*side, out_side) };
    let filled = bias.values.iter().flat_map(|&bias| vec![bias; out_side * out_side]);
    let one: Vec<f32> = filled.collect();
    let mut values = one.repeat(*batch);
    let in_place = |at: usize, tap: usize| (2 * at + tap).checked_sub(padding).filter(|&at| at < fine);
    for image in 0..*batch {
        for (input, output) in (0..*channels).flat_map(|input| (0..outputs).map(move |output| (input, output))) {
            let (first, second) = if transposed { (input, output) } else { (output, input) };
            let taps = &weight.values[(first * fine_channels + second) * kernel * kernel..][..kernel * kernel];
            let x = &x.values[(image * channels + input) * side * side..][..side * side];
            let y = &mut values[(image * outputs + output) * out_side * out_side..][..out_side * out_side];
            for (row, column) in (0..coarse).flat_map(|row| (0..coarse).map(move |column| (row, column))) {
                for (tap, weight) in taps.iter().enumerate() {
                    let (Some(v), Some(u)) = (in_place(row, tap / kernel), in_place(column, tap % kernel)) else {
                        continue;
                    };
                    let (fine, coarse) = (v * fine + u, row * coarse + column);
                    let (from, to) = if transposed { (coarse, fine) } else { (fine, coarse) };
                    y[to] += weight * x[from];
                }
            }
        }
    }
    Array { shape: vec![*batch, outputs, out_side, out_side], values }
}
