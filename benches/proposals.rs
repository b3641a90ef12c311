//! Times what the page computes with the model, natively on one thread: the maps of a scene and a hundred proposed
//! balls, and each part of them.
//!
//! Every time is the total for 50 scenes, two of each template: `cargo bench --features ndarray --bench proposals`.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use pathlight::agents::{self, ranking};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::nets::PathNet;
use pathlight::puzzle::task::{Task, TaskId, ids};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::raster::{scene_channels, scene_coverage};

fn proposals(criterion: &mut Criterion) {
    let bytes = include_bytes!("../assets/within-0.safetensors");
    let nets = PathNet::load(bytes).expect("our own weights").0;
    let ids: Vec<TaskId> = TEMPLATES.iter().flat_map(|template| ids(template).step_by(50)).collect();
    let load = |id: &TaskId| Task::load(*id).expect("an id of the template");
    let tasks: Vec<(Task, Vec<f32>)> = ids
        .iter()
        .map(load)
        .map(|task| {
            let logits = nets.cell_logits(&task.scene).expect("the weights have a dynamics net");
            (task, logits)
        })
        .collect();

    let mut group = criterion.benchmark_group(format!("{} scenes", tasks.len()));
    group.sample_size(10);
    let mut bench = |name: &str, work: &dyn Fn(&Task, &[f32])| {
        group.bench_function(name, |bencher| {
            bencher.iter(|| tasks.iter().for_each(|(task, logits)| work(task, logits)))
        });
    };
    bench("load", &|task, _| drop(black_box(load(&task.id))));
    bench("set cells", &|task, _| drop(black_box(Box::new(scene_channels(&task.scene)))));
    bench("covered shares", &|task, _| drop(black_box(scene_coverage(&task.scene))));
    bench("four nets", &|task, _| drop(black_box(nets.imagine(&task.scene))));
    bench("logits of cells", &|task, _| drop(black_box(nets.cell_logits(&task.scene))));
    bench("probability map", &|task, logits| drop(black_box(ranking::probability_map(logits, &task.scene))));
    bench("ranked", &|task, logits| drop(black_box(ranking::ranked(logits, &task.scene, MAX_ATTEMPTS))));
    bench("a hundred balls", &|task, _| {
        drop(black_box(agents::propose(&nets, &task.scene, task.id.seed(0), MAX_ATTEMPTS)))
    });
    bench("a hundred balls from the placement map", &|task, _| {
        drop(black_box(agents::placement::proposals(
            &nets.imagine(&task.scene).placement,
            &task.scene,
            0,
            MAX_ATTEMPTS,
        )));
    });
    group.finish();
}

criterion_group!(benches, proposals);
criterion_main!(benches);
