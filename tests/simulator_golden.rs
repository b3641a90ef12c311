//! Rollouts are bit-identical to those of the present version of each engine, natively and in wasm.
//!
//! One digest for each template, over three of its tasks, each without a ball and with two: 225 rollouts; one of its
//! tasks for rapier's own pipeline, natively only. The same file runs under `cargo test` and `wasm-pack test --node`,
//! against the same digests. To change the simulation on purpose, raise the version and run `UPDATE_GOLDEN=1 cargo test
//! --release --test simulator_golden`.

use md5::{Digest, Md5};
use pathlight::puzzle::action::Obstacles;
use pathlight::puzzle::sampling::uniform_ball;
use pathlight::puzzle::task::{Task, ids};
use pathlight::puzzle::templates::{TEMPLATES, Template};
use pathlight::simulator::Engine;
use rand::SeedableRng;
use rand_pcg::Pcg32;

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn every_rollout_is_as_it_was() {
    compare(Engine::Box2d, 3, "rollouts.txt", include_str!("golden/rollouts.txt"));
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn every_rollout_of_rapier_is_as_it_was() {
    compare(Engine::Rapier, 1, "rapier.txt", include_str!("golden/rapier.txt"));
}

/// Compares the rollouts of an engine, on the first tasks of each template, with the digests of a file.
fn compare(engine: Engine, tasks: usize, file: &str, golden: &str) {
    let lines =
        TEMPLATES.iter().map(|template| format!("{:05} {}\n", template.number, digest(engine, template, tasks)));
    let digests = format!("simulator version {}\n{}", engine.version(), lines.collect::<String>());
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        let path = format!("{}/tests/golden/{file}", env!("CARGO_MANIFEST_DIR"));
        std::fs::write(&path, &digests).unwrap_or_else(|error| panic!("{path}: {error}"));
        return;
    }
    let pairs = digests.lines().zip(golden.lines().chain(std::iter::repeat("")));
    let changed: Vec<&str> = pairs.filter(|(now, then)| now != then).map(|(now, _)| now).collect();
    assert!(changed.is_empty() && digests.len() == golden.len(), "not as in tests/golden/{file}: {changed:?}");
}

/// Returns the MD5 of everything that `simulate` returns; `outcome` must agree with it.
fn digest(engine: Engine, template: &'static Template, tasks: usize) -> String {
    let mut md5 = Md5::new();
    for id in ids(template).step_by(40).take(tasks) {
        let scene = Task::load(id).expect("an id of the template").scene;
        let mut random = Pcg32::seed_from_u64(id.number.into());
        let mut ball = || Some(uniform_ball(&Obstacles::new(&scene), &mut random).expect("the scene has room"));
        let balls = [None, ball(), ball()];
        for ball in balls {
            let rollout = engine.simulate(&scene, ball).expect("a valid ball");
            let short = engine.outcome(&scene, ball).expect("a valid ball");
            assert_eq!((short.solved, short.steps), (rollout.solved, rollout.steps), "{id} {ball:?}");
            md5.update(format!("{id} {ball:?} {} {} {:?}\n", rollout.solved, rollout.steps, rollout.bodies));
            for value in rollout.poses.iter().flatten() {
                md5.update(value.to_bits().to_le_bytes());
            }
            md5.update(rollout.touching.iter().map(|&touches| u8::from(touches)).collect::<Vec<u8>>());
        }
    }
    md5.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
