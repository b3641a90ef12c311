//! Runs the nets natively, as one implementation of `make bench`; `benches/bench.mjs` decides when each implementation
//! runs.
//!
//! `inputs TASK FOLDER` writes the input of the other implementations: the nets, the scene and a batch. The other
//! commands are `forward TASK` (the four nets), `maps TASK` (all five maps), `propose TASK OTHER` (a hundred balls for
//! each task in turn) and `train`. Each prepares its work and prints a line of numbers that the other implementations
//! must reproduce. Then, for each line of standard input, it reads a number of repetitions and prints the milliseconds
//! of each.

use std::path::Path;
use std::time::Instant;
use std::{env, fs};

use pathlight::agents;
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::nets::training::{PathsBatch, Sample, Trainer};
use pathlight::nets::{Imagined, Parameter, PathNet};
use pathlight::puzzle::task::Task;
use pathlight::raster::{Bitmap, Coverage, scene_channels, scene_coverage};
use pathlight_lab::data::collect::read_solutions;
use pathlight_lab::data::solutions::Solution;
use pathlight_lab::training::paths::sample;
use repeat::{repeat, stopwatch};
use safetensors::tensor::{Dtype, TensorView};

mod onnx;
#[path = "../repeat.rs"]
mod repeat;

/// The lab's allocator.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

const WEIGHTS: &str = "assets/within-0.safetensors";
const SOLUTIONS: &str = "assets/solutions.jsonl";
const BATCH: usize = 32;
/// Batches to train on in turn. On a single batch the losses would approach zero, and the gradients would be so small
/// that they become subnormal, which takes several times as long. No real training does that.
const BATCHES: usize = 24;
/// Learning rate of Adam.
const LEARNING_RATE: f64 = 3e-3;
/// Steps whose losses must agree.
const COMPARED: usize = 3;

fn main() {
    // Cargo starts the bench in the lab's folder.
    env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).expect("the repository is there");
    let arguments: Vec<String> = env::args().skip(1).filter(|argument| argument != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["inputs", task, folder] => {
            inputs(&nets(), &load(task), Path::new(folder));
            let start = Instant::now();
            for _ in 0..100 {
                std::hint::black_box(scene_channels(&load(task).scene));
            }
            let milliseconds = start.elapsed().as_secs_f64() * 1e3 / 100.0;
            println!("ours also lays out the task and draws its scene, which takes {milliseconds:.3} ms natively");
        }
        ["forward", task] => {
            let (nets, task) = (nets(), load(task));
            let imagine = || nets.imagine(&task.scene);
            let Imagined { base, target, action, placement } = imagine();
            repeat(&format!("{:?}", [base, target, action, placement].concat()), || stopwatch(imagine));
        }
        ["maps", task] => {
            let (nets, task) = (nets(), load(task));
            let logits = || nets.cell_logits(&task.scene).expect("the weights have a dynamics net");
            let Imagined { base, target, action, placement } = nets.imagine(&task.scene);
            let result = [base, target, action, placement, logits()].concat();
            // The nets alone, as the other engines run them: not which balls fit.
            repeat(&format!("{result:?}"), || stopwatch(|| (nets.imagine(&task.scene), logits())));
        }
        ["propose", task, other] => {
            let nets = nets();
            let mut tasks = [load(task), load(other)].into_iter().cycle();
            let mut propose = || {
                let Task { id, scene, .. } = tasks.next().expect("endless");
                agents::propose(&nets, &scene, id.seed(0), MAX_ATTEMPTS)
            };
            let balls: Vec<[f64; 3]> = propose().into_iter().map(|proposal| proposal.ball.into()).collect();
            repeat(&format!("{:?}", balls.concat()), || stopwatch(&mut propose));
        }
        ["train"] => {
            let mut step = training();
            let losses: Vec<f32> = (0..COMPARED).map(|_| step()).collect();
            repeat(&format!("{losses:?}"), || stopwatch(&mut step));
        }
        _ => println!("`make bench` runs this, with implementations to compare it with"),
    }
}

fn load(task: &str) -> Task {
    Task::load(task.parse().expect("a task's id")).expect("a task")
}

fn nets() -> PathNet {
    let bytes = fs::read(WEIGHTS).expect("the weights are in assets");
    PathNet::load(&bytes).expect("the weights fit").0
}

/// Writes the nets as ONNX graphs and their parameters in single precision; the scene's set cells and covered shares,
/// `[5, 64, 64]` each; and the batches, `[24, 32, 9, 64, 64]`, scenes before targets.
fn inputs(nets: &PathNet, task: &Task, folder: &Path) {
    let write = |name: &str, bytes: Vec<u8>| fs::write(folder.join(name), bytes).expect("the folder can be written");
    write("nets.onnx", onnx::four_nets(nets));
    write("all-nets.onnx", onnx::all_nets(nets));
    let parameters = nets.parameters().into_iter();
    let parameters: Vec<_> =
        parameters.map(|(name, Parameter { shape, values })| (name, shape, bytes(values))).collect();
    let views = parameters.iter().map(|(name, shape, bytes)| {
        (name, TensorView::new(Dtype::F32, shape.clone(), bytes).expect("four bytes per value"))
    });
    write("weights.safetensors", safetensors::serialize(views, None).expect("names and sizes come from the nets"));
    write("scene.f32", bytes(scene_channels(&task.scene).iter().flat_map(Bitmap::to_f32)));
    write("coverage.f32", bytes(scene_coverage(&task.scene).iter().flat_map(Coverage::to_f32)));
    let images = batches().into_iter().flatten().flat_map(|sample| sample.scene.into_iter().chain(sample.targets));
    write("batches.f32", bytes(images.flat_map(|image| image.to_f32().collect::<Vec<_>>())));
}

fn bytes(values: impl IntoIterator<Item = f32>) -> Vec<u8> {
    values.into_iter().flat_map(f32::to_le_bytes).collect()
}

/// Batches of solutions, each from all templates.
fn batches() -> Vec<Vec<Sample>> {
    let solutions = read_solutions(Path::new(SOLUTIONS)).expect("the solutions are in assets");
    let chosen = |number: usize| solutions.iter().skip(number).step_by(solutions.len() / BATCH).take(BATCH);
    let sample = |&Solution { task, ball }: &Solution| {
        sample(&Task::load(task).expect("a task").scene, ball).expect("a valid ball")
    };
    (0..BATCHES).map(|number| chosen(10 * number).map(sample).collect()).collect()
}

/// The step of `pathlight-lab train paths`, on one batch after another; returns the sum of the losses.
fn training() -> impl FnMut() -> f32 {
    // The shipped weights, because the other implementations start from the same file.
    let mut trainer = Trainer::from_nets(nets());
    let batches = batches();
    let mut number = 0;
    move || {
        let samples = &batches[number % BATCHES];
        number += 1;
        let batch = PathsBatch::new(samples.iter().map(|sample| (sample, false)));
        // In rayon's pool, as in the lab.
        rayon::scope(|_| trainer.step(batch, LEARNING_RATE)).iter().sum()
    }
}
