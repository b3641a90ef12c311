//! The speed of the simulator on one core: 500 mixed rollouts, 20 of each template, all with a random valid ball.
//!
//! Criterion's elements are steps of rollouts, so its `elem/s` are steps per second per core. Steps in which all bodies
//! sleep are included.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pathlight::puzzle::action::{Action, Ball};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{outcome, simulate};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

fn rollouts(criterion: &mut Criterion) {
    let mut random = Pcg32::seed_from_u64(0);
    let tasks = TEMPLATES.iter().flat_map(|template| Task::of(template).step_by(5));
    let placed: Vec<(Scene, Ball)> = tasks
        .map(|Task { scene, .. }| {
            let mut action = || Action { x: random.random(), y: random.random(), r: random.random() };
            let ball = std::iter::repeat_with(|| action().place(&scene))
                .find_map(Result::ok)
                .expect("the sequence has no end");
            (scene, ball)
        })
        .collect();
    let run = |(scene, ball): &(Scene, Ball)| outcome(scene, Some(*ball)).expect("a valid ball").steps as u64;
    let steps = placed.iter().map(run).sum();

    let mut group = criterion.benchmark_group("500 mixed rollouts");
    group.throughput(Throughput::Elements(steps)).sample_size(10);
    group.bench_function("outcome", |bencher| bencher.iter(|| placed.iter().map(run).sum::<u64>()));
    group.bench_function("with poses", |bencher| {
        bencher.iter(|| placed.iter().for_each(|(scene, ball)| drop(black_box(simulate(scene, Some(*ball))))));
    });
    group.finish();
}

criterion_group!(benches, rollouts);
criterion_main!(benches);
