//! The nets natively by tract, one thread: tract-nets ONNX SCENE. One implementation of `make bench`.

use std::{env, fs};

use repeat::{repeat, stopwatch};
use tract_nets::Nets;

#[path = "../../../repeat.rs"]
mod repeat;

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [onnx, scene] = &arguments[..] else { panic!("give the ONNX file and the scene") };
    let nets = Nets::load(&fs::read(onnx).expect("the ONNX file")).expect("tract reads the file");
    let bytes = fs::read(scene).expect("the scene");
    let scene: Vec<f32> = bytes.as_chunks().0.iter().map(|&number| f32::from_le_bytes(number)).collect();
    let imagine = || nets.imagine(&scene).expect("the shapes are right");
    repeat(&format!("{:?}", imagine()), || stopwatch(imagine));
}
