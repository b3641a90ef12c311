//! A naive reference implementation of the nets: plain nested loops, written for readability and not for speed. Images
//! are stored channel by channel, row by row.

use half::f16;
use pathlight::nets::success_net::RADII;
use pathlight::puzzle::scene::Scene;
use pathlight::raster::{CELLS, CHANNELS, SIDE, scene_channels, scene_coverage};
use safetensors::SafeTensors;

/// Returns the four maps of a scene, in the order base, target, action, placement.
pub fn imagine(file: &SafeTensors, scene: &Scene) -> [Vec<f32>; 4] {
    let scene = channels(scene);
    let base = hourglass(file, "base", &scene, CHANNELS);
    let target = hourglass(file, "target", &scene, CHANNELS);
    let with = |map: &[f32]| [&scene[..], &target, map].concat();
    let action = hourglass(file, "action", &with(&base), CHANNELS + 2);
    let placement = hourglass(file, "placement", &with(&action), CHANNELS + 2);
    [base, target, action, placement]
}

/// Returns the logits of the cells, from the success net or the dynamics net: the mean over the scene and its mirror
/// image. Both nets read the covered share of each cell.
pub fn cell_logits(file: &SafeTensors, net: &str, scene: &Scene) -> Vec<f32> {
    let mirror = |image: &[f32]| -> Vec<f32> { image.chunks(SIDE).flat_map(|row| row.iter().rev()).copied().collect() };
    let scene: Vec<f32> =
        scene_coverage(scene).iter().flat_map(|channel| channel.to_f32().collect::<Vec<_>>()).collect();
    let mirrored = mirror(&u_net(file, net, &mirror(&scene)));
    u_net(file, net, &scene).iter().zip(mirrored).map(|(a, b)| (a + b) / 2.0).collect()
}

fn channels(scene: &Scene) -> Vec<f32> {
    scene_channels(scene).iter().flat_map(|channel| channel.to_f32()).collect()
}

/// Six convolutions, six transposed convolutions and a sigmoid.
fn hourglass(file: &SafeTensors, net: &str, images: &[f32], channels: usize) -> Vec<f32> {
    let (mut x, mut inputs, mut side) = (images.to_vec(), channels, SIDE);
    for layer in 0..6 {
        let (weight, bias) = layer_of(file, &format!("{net}.down.{layer}"));
        x = relu(convolve(&x, inputs, side, &weight, &bias));
        (inputs, side) = (bias.len(), side / 2);
    }
    for layer in 0..6 {
        let (weight, bias) = layer_of(file, &format!("{net}.up.{layer}"));
        x = convolve_transposed(&x, inputs, side, &weight, &bias);
        (inputs, side) = (bias.len(), side * 2);
        if layer < 5 {
            x = relu(x);
        }
    }
    x.iter().map(|&logit| 1.0 / (1.0 + (-logit).exp())).collect()
}

/// Five convolutions and five transposed ones, of which each but the first reads the previous layer and the encoder's
/// output of the same size. The first channels of the last are the logits.
fn u_net(file: &SafeTensors, net: &str, images: &[f32]) -> Vec<f32> {
    let (mut x, mut inputs, mut side) = (images.to_vec(), CHANNELS, SIDE);
    let mut encoded = Vec::new();
    for layer in 0..5 {
        let (weight, bias) = layer_of(file, &format!("{net}.down.{layer}"));
        x = relu(convolve(&x, inputs, side, &weight, &bias));
        (inputs, side) = (bias.len(), side / 2);
        encoded.push(x.clone());
    }
    for layer in 0..5 {
        if layer > 0 {
            let skip = &encoded[4 - layer];
            x.extend_from_slice(skip);
            inputs += skip.len() / (side * side);
        }
        let (weight, bias) = layer_of(file, &format!("{net}.up.{layer}"));
        x = convolve_transposed(&x, inputs, side, &weight, &bias);
        (inputs, side) = (bias.len(), side * 2);
        if layer < 4 {
            x = relu(x);
        }
    }
    x.truncate(RADII * CELLS);
    x
}

fn relu(x: Vec<f32>) -> Vec<f32> {
    x.into_iter().map(|value| value.max(0.0)).collect()
}

/// Returns the weight and the bias; a 2 x 2 kernel becomes the centre of a 4 x 4 kernel.
fn layer_of(file: &SafeTensors, layer: &str) -> (Vec<f32>, Vec<f32>) {
    let values = |name: &str| {
        let view = file.tensor(&format!("{layer}.{name}")).expect("every layer has weight and bias");
        (view.shape().to_vec(), values_of(file, &format!("{layer}.{name}")))
    };
    let (shape, weight) = values("weight");
    let (_, bias) = values("bias");
    if shape[2] == 4 {
        return (weight, bias);
    }
    assert_eq!(shape[2..], [2, 2]);
    let mut whole = vec![0.0; shape[0] * shape[1] * 16];
    for (index, value) in weight.into_iter().enumerate() {
        let (pair, row, column) = (index / 4, index / 2 % 2, index % 2);
        whole[pair * 16 + (row + 1) * 4 + column + 1] = value;
    }
    (whole, bias)
}

/// Returns the values of a parameter, stored in half precision, or as multiples of a step of which few need more than a
/// byte.
fn values_of(file: &SafeTensors, name: &str) -> Vec<f32> {
    let bytes = |name: &str| file.tensor(name).map(|view| view.data().to_vec());
    let pair = |pair: &[u8]| [pair[0], pair[1]];
    let four = |four: &[u8]| [four[0], four[1], four[2], four[3]];
    let data = bytes(name).expect("a parameter");
    let Ok(step) = bytes(&format!("{name}.step")) else {
        return data.chunks_exact(2).map(|bytes| f16::from_le_bytes(pair(bytes)).to_f32()).collect();
    };
    let step = f32::from_le_bytes(four(&step));
    let mut values: Vec<f32> = data.iter().map(|&byte| f32::from(byte as i8) * step).collect();
    if let (Ok(outliers), Ok(at)) = (bytes(&format!("{name}.outliers")), bytes(&format!("{name}.outliers.at"))) {
        for (multiple, index) in outliers.chunks_exact(2).zip(at.chunks_exact(4)) {
            values[u32::from_le_bytes(four(index)) as usize] = f32::from(i16::from_le_bytes(pair(multiple))) * step;
        }
    }
    values
}

/// 4 x 4, stride 2, padding 1. Weight: out, in, row, column.
fn convolve(x: &[f32], inputs: usize, side: usize, weight: &[f32], bias: &[f32]) -> Vec<f32> {
    let half = side / 2;
    let mut out = vec![0.0; bias.len() * half * half];
    for (o, &bias) in bias.iter().enumerate() {
        for row in 0..half {
            for column in 0..half {
                let mut sum = bias;
                for i in 0..inputs {
                    for (k, tap) in weight[(o * inputs + i) * 16..][..16].iter().enumerate() {
                        let (y, z) = ((2 * row + k / 4).wrapping_sub(1), (2 * column + k % 4).wrapping_sub(1));
                        if y < side && z < side {
                            sum += tap * x[(i * side + y) * side + z];
                        }
                    }
                }
                out[(o * half + row) * half + column] = sum;
            }
        }
    }
    out
}

/// The adjoint of `convolve`. Weight: in, out, row, column.
fn convolve_transposed(x: &[f32], inputs: usize, side: usize, weight: &[f32], bias: &[f32]) -> Vec<f32> {
    let (outputs, double) = (bias.len(), side * 2);
    let mut out: Vec<f32> = bias.iter().flat_map(|&bias| vec![bias; double * double]).collect();
    for i in 0..inputs {
        for row in 0..side {
            for column in 0..side {
                let value = x[(i * side + row) * side + column];
                for o in 0..outputs {
                    for (k, tap) in weight[(i * outputs + o) * 16..][..16].iter().enumerate() {
                        let (y, z) = ((2 * row + k / 4).wrapping_sub(1), (2 * column + k % 4).wrapping_sub(1));
                        if y < double && z < double {
                            out[(o * double + y) * double + z] += tap * value;
                        }
                    }
                }
            }
        }
    }
    out
}
