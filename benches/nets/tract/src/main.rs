//! The nets natively by tract, one thread: tract-nets ONNX SCENE. Answers bench.mjs as ../../../repeat.rs.

use std::time::Instant;
use std::{env, fs, io};

use tract_nets::Nets;

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [onnx, scene] = &arguments[..] else { panic!("give the ONNX file and the scene") };
    let nets = Nets::load(&fs::read(onnx).expect("the ONNX file")).expect("tract reads the file");
    let bytes = fs::read(scene).expect("the scene");
    let scene: Vec<f32> = bytes.as_chunks().0.iter().map(|&number| f32::from_le_bytes(number)).collect();
    let imagine = || nets.imagine(&scene).expect("the shapes are right");
    println!("{:?}", imagine());
    for line in io::stdin().lines() {
        let repetitions = 0..line.expect("text").parse::<usize>().expect("a number of repetitions");
        let time = |_| {
            let start = Instant::now();
            std::hint::black_box(imagine());
            start.elapsed().as_secs_f64() * 1e3
        };
        println!("{:?}", repetitions.map(time).collect::<Vec<f64>>());
    }
}
