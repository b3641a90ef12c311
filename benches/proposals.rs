//! Times what the page computes with the model, natively on one thread: the maps of a scene and a hundred proposed
//! balls, and each part of them.
//!
//! Every time is the total for 50 scenes, two of each template: `cargo bench --features ndarray --bench proposals`.

use std::sync::LazyLock;

use divan::Bencher;
use pathlight::agents::{self, placement, ranking};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::nets::PathNet;
use pathlight::puzzle::task::{Task, ids};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::raster::{scene_channels, scene_coverage};

static NETS: LazyLock<PathNet> = LazyLock::new(|| {
    let bytes = include_bytes!("../assets/within-0.safetensors");
    PathNet::load(bytes).expect("our own weights").0
});

static TASKS: LazyLock<Vec<Task>> = LazyLock::new(|| {
    let ids = TEMPLATES.iter().flat_map(|template| ids(template).step_by(50));
    ids.map(|id| Task::load(id).expect("an id of the template")).collect()
});

static LOGITS: LazyLock<Vec<Vec<f32>>> = LazyLock::new(|| TASKS.iter().map(logits).collect());

fn logits(task: &Task) -> Vec<f32> {
    NETS.cell_logits(&task.scene).expect("the weights have a dynamics net")
}

fn main() {
    LazyLock::force(&LOGITS);
    divan::Divan::from_args().sample_count(10).sample_size(1).main();
}

fn of_all<T>(bencher: Bencher, work: impl Fn(&Task, &[f32]) -> T) {
    bencher.bench_local(|| {
        TASKS.iter().zip(&*LOGITS).for_each(|(task, logits)| drop(divan::black_box(work(task, logits))))
    });
}

#[divan::bench]
fn load(bencher: Bencher) {
    of_all(bencher, |task, _| Task::load(task.id));
}

#[divan::bench]
fn set_cells(bencher: Bencher) {
    of_all(bencher, |task, _| Box::new(scene_channels(&task.scene)));
}

#[divan::bench]
fn covered_shares(bencher: Bencher) {
    of_all(bencher, |task, _| scene_coverage(&task.scene));
}

#[divan::bench]
fn four_nets(bencher: Bencher) {
    of_all(bencher, |task, _| NETS.imagine(&task.scene));
}

#[divan::bench]
fn logits_of_cells(bencher: Bencher) {
    of_all(bencher, |task, _| logits(task));
}

#[divan::bench]
fn probability_map(bencher: Bencher) {
    of_all(bencher, |task, logits| ranking::probability_map(logits, &task.scene));
}

#[divan::bench]
fn ranked(bencher: Bencher) {
    of_all(bencher, |task, logits| ranking::ranked(logits, &task.scene, MAX_ATTEMPTS));
}

#[divan::bench]
fn a_hundred_balls(bencher: Bencher) {
    of_all(bencher, |task, _| agents::propose(&NETS, &task.scene, task.id.seed(0), MAX_ATTEMPTS));
}

#[divan::bench]
fn a_hundred_balls_from_the_placement_map(bencher: Bencher) {
    of_all(bencher, |task, _| placement::proposals(&NETS.imagine(&task.scene).placement, &task.scene, 0, MAX_ATTEMPTS));
}
