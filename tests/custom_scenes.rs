//! Random scenes within the limits round-trip through JSON and never break the simulator: no panic, no pose that is not
//! a number, and no more steps than the maximum. The walls, 5 px thick as in PHYRE, do not hold a light body that is
//! squeezed under a heavy one or between static ones. Such scenes are rare, and counted.
//!
//! `PATHLIGHT_SCENES=1000000 cargo test --release --test custom_scenes -- --nocapture` tries more scenes and prints its
//! progress; `PATHLIGHT_FIRST_SCENE` continues from there. The slower rapier gets a fiftieth of the scenes.
#![cfg(not(target_arch = "wasm32"))]

use std::f64::consts::TAU;
use std::ops::{Range, RangeInclusive};

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::custom_scene::{CustomBody, CustomScene, VERSION};
use pathlight::puzzle::dimensions::{BALL_RADIUS, BAR_LENGTH, BAR_THICKNESS, Dimensions, JAR_HEIGHT, STICK_LENGTH};
use pathlight::puzzle::rollout::{MAX_STEPS, Pose};
use pathlight::session::scene_check::problems;
use pathlight::simulator::Engine;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

/// Range of positions allowed for a dynamic body, px: the walls are at 0 and 256, and a body that is pressed into one
/// is pushed out again.
const INSIDE: RangeInclusive<f32> = -32.0..=288.0;

/// At most one of this many scenes lets a body out. In a million, seven did.
const SCENES_PER_ESCAPE: u64 = 50_000;

/// Number of scenes in a normal run.
const SCENES: u64 = 5_000;

/// Draws a number from a range, often one of its ends or a small one.
fn length(random: &mut impl Rng, range: RangeInclusive<f64>) -> f64 {
    let (least, most) = range.into_inner();
    match random.random_range(0..8) {
        0 => least,
        1 => most,
        2 | 3 => random.random_range(least..=most),
        _ => random.random_range(least..=least + (most - least) / 8.0),
    }
}

fn body(random: &mut impl Rng) -> CustomBody {
    let dimensions = match random.random_range(0..4) {
        0 => Dimensions::Ball { radius: length(random, BALL_RADIUS) },
        1 => Dimensions::Bar { length: length(random, BAR_LENGTH), thickness: length(random, BAR_THICKNESS) },
        2 => Dimensions::Jar { height: length(random, JAR_HEIGHT) },
        _ => Dimensions::StandingSticks { length: length(random, STICK_LENGTH) },
    };
    let [x, y] = [0; 2].map(|_| random.random_range(0.0..256.0));
    let angle = if random.random() { 0.0 } else { random.random_range(-TAU..=TAU) };
    CustomBody { dimensions, x, y, angle, dynamic: random.random() }
}

/// Returns a playable scene: bodies are added as long as the check allows them.
fn scene(seed: u64) -> CustomScene {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let wanted = random.random_range(2..24);
    let mut scene = CustomScene { version: VERSION, name: None, body1: 0, body2: 1, bodies: Vec::new() };
    let mut tries = 0;
    // A crowded scene may have no room for more bodies.
    while scene.bodies.len() < 2 || (scene.bodies.len() < wanted && tries < 200) {
        tries += 1;
        let mut next = body(&mut random);
        next.dynamic |= scene.bodies.is_empty();
        scene.bodies.push(next);
        let problems = problems(&scene);
        // A single body lacks a goal, which is not a problem of that body.
        let refused = if scene.bodies.len() < 2 {
            problems.iter().any(|problem| problem.body.is_some())
        } else {
            !problems.is_empty()
        };
        if refused {
            scene.bodies.pop();
        }
    }
    scene
}

/// Returns the seeds of the scenes to try.
fn seeds() -> Range<u64> {
    let number =
        |name: &str, usual| std::env::var(name).map_or(usual, |text| text.parse().expect("a number of scenes"));
    number("PATHLIGHT_FIRST_SCENE", 0)..number("PATHLIGHT_SCENES", SCENES)
}

#[test]
fn random_scenes_come_back_from_json_and_never_break_the_simulator() {
    let seeds = seeds();
    let escapes = try_scenes(seeds.clone(), Engine::Box2d);
    assert!(
        escapes.len() as u64 <= (seeds.end - seeds.start) / SCENES_PER_ESCAPE,
        "scenes that let bodies out: {escapes:?}"
    );
}

/// One of 100,000 random scenes had such a wedge. Without a limit, the impulses on the ball grow by a tenth in each
/// step.
#[test]
fn a_ball_that_is_wedged_between_static_bodies_stays_a_ball() {
    let body = |dimensions, x, y, angle, dynamic| CustomBody { dimensions, x, y, angle, dynamic };
    let bodies = vec![
        body(Dimensions::Ball { radius: 9.0 }, 250.0, 197.0, 0.0, true),
        body(Dimensions::Bar { length: 38.0, thickness: 21.0 }, 218.5, 199.0, 5.625, false),
        body(Dimensions::Ball { radius: 4.25 }, 236.5, 206.0, 0.0, false),
    ];
    let scene = CustomScene { version: VERSION, name: None, body1: 0, body2: 1, bodies };
    assert_eq!(problems(&scene), []);
    let rollout = Engine::Box2d.simulate(&scene.to_scene(), None).expect("no ball to refuse");
    assert!(rollout.poses.as_flattened().iter().all(|number| number.is_finite()));
}

#[test]
fn nor_do_they_break_rapier() {
    // It more often pushes bodies that are pressed into a wall through the wall.
    let Range { start, end } = seeds();
    try_scenes(start / 50..end / 50, Engine::Rapier);
}

/// Tries the scenes of these seeds, and returns those that let a body out of the walls.
fn try_scenes(seeds: Range<u64>, engine: Engine) -> Vec<u64> {
    let end = seeds.end;
    let block = |first| {
        println!("{engine:?}: scenes from {first}");
        let tried = (first..end.min(first + SCENES)).into_par_iter();
        tried.filter(|&seed| lets_a_body_out(seed, engine)).collect::<Vec<u64>>()
    };
    seeds.step_by(SCENES as usize).flat_map(block).collect()
}

/// Tries a scene, and returns whether it lets a body out of the walls.
fn lets_a_body_out(seed: u64, engine: Engine) -> bool {
    let custom = scene(seed);
    let read = CustomScene::read(serde_json::to_value(&custom).expect("plain data"));
    assert_eq!(read.as_ref(), Ok(&custom), "scene {seed}");
    let scene = custom.to_scene();
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut coordinate = || f64::from(random.random_range(2..254));
    let ball = Some(Ball { x: coordinate(), y: coordinate(), r: coordinate() / 8.0 })
        .filter(|ball| ball.check(&scene).is_ok());
    let rollout = engine.simulate(&scene, ball).expect("a valid ball");
    assert!(rollout.steps <= MAX_STEPS && rollout.poses.len() == (rollout.steps + 1) * rollout.bodies.len());
    let is_number = |pose: &Pose| pose.iter().all(|number| number.is_finite());
    assert!(rollout.poses.iter().all(is_number), "scene {seed}: {custom:?}, {ball:?}");
    !rollout.poses.iter().all(|[x, y, _]| INSIDE.contains(x) && INSIDE.contains(y))
}
