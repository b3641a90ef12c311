//! Runs the nets natively with tract on one thread: tract-nets ONNX IMAGE…. One implementation of `make bench`.

use std::{env, fs};

use repeat::{repeat, stopwatch};
use tract_nets::Nets;

#[path = "../../../repeat.rs"]
mod repeat;

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [onnx, images @ ..] = &arguments[..] else { panic!("give the ONNX file and the images of the scene") };
    let nets = Nets::load(&fs::read(onnx).expect("the ONNX file")).expect("tract reads the file");
    let bytes: Vec<u8> = images.iter().flat_map(|image| fs::read(image).expect("an image")).collect();
    let images: Vec<f32> = bytes.as_chunks().0.iter().map(|&number| f32::from_le_bytes(number)).collect();
    let imagine = || nets.imagine(&images).expect("the shapes are right");
    repeat(&format!("{:?}", imagine()), || stopwatch(imagine));
}
