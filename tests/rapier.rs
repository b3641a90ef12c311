//! rapier's own pipeline as the second engine: the same scene, gravity, friction and success rule, with the same result
//! on every thread.
#![cfg(not(target_arch = "wasm32"))]

use std::f64::consts::TAU;

use pathlight::puzzle::action::{Ball, Invalid};
use pathlight::puzzle::rollout::{GOAL_STEPS, MAX_STEPS, STEPS_PER_SECOND};
use pathlight::puzzle::scene::{Body, Role, Scene, Shape, ShapeType, rectangle};
use pathlight::puzzle::task::Task;
use pathlight::simulator::Engine;
use rayon::prelude::*;

fn body(shape: Shape, [x, y]: [f64; 2], angle: f64, role: Role) -> Body {
    let dynamic = !matches!(role, Role::Black | Role::Purple);
    Body { x, y, angle, dynamic, shape_type: ShapeType::Bar, role, shapes: vec![shape] }
}

/// A scene with a green ball of 6 px here, and further bodies, the first of which is the goal.
fn scene(object: [f64; 2], others: Vec<Body>) -> Scene {
    let object = body(Shape::Circle(6.0), object, 0.0, Role::Green);
    Scene { body1: 0, body2: 1, bodies: std::iter::once(object).chain(others).collect() }
}

/// A goal that nothing reaches.
fn far_goal() -> Body {
    body(rectangle(10.0, 10.0), [250.0, 250.0], 0.0, Role::Purple)
}

#[test]
fn a_ball_falls_as_gravity_says_and_comes_to_rest_on_the_floor() {
    let rollout = Engine::Rapier.simulate(&scene([128.0, 200.0], vec![far_goal()]), None).expect("no ball to refuse");
    assert_eq!((rollout.steps, rollout.solved), (MAX_STEPS, false));
    let height = |step: usize| f64::from(rollout.pose(step, 0).expect("it moves")[1]);
    let fallen = 0.5 * 9.8 * 6.0;
    assert!((height(0) - height(STEPS_PER_SECOND) - fallen).abs() < 0.02 * fallen, "{}", height(STEPS_PER_SECOND));
    assert!((height(MAX_STEPS) - 6.0).abs() < 0.2, "{}", height(MAX_STEPS));
    assert_eq!(rollout.row(MAX_STEPS), rollout.row(MAX_STEPS - 60), "it sleeps");
}

#[test]
fn the_angle_of_a_rolling_ball_is_not_wrapped() {
    let slope = body(rectangle(300.0, 6.0), [128.0, 100.0], -0.2, Role::Black);
    let rolling = scene([20.0, 140.0], vec![far_goal(), slope]);
    let rollout = Engine::Rapier.simulate(&rolling, None).expect("no ball to refuse");
    let turned = f64::from(rollout.pose(rollout.steps, 0).expect("it moves")[2]);
    assert!(turned < -TAU, "{turned}");
    let angles = (0..=rollout.steps).map(|step| rollout.pose(step, 0).expect("it moves")[2]);
    assert!(angles.clone().zip(angles.skip(1)).all(|(one, next)| (next - one).abs() < 1.5), "no jumps");
}

#[test]
fn a_touch_of_three_seconds_solves() {
    let goal = body(rectangle(60.0, 6.0), [128.0, 60.0], 0.0, Role::Purple);
    let rollout = Engine::Rapier.simulate(&scene([128.0, 80.0], vec![goal]), None).expect("no ball to refuse");
    assert!(rollout.solved);
    assert!(rollout.touching[rollout.steps + 1 - GOAL_STEPS..].iter().all(|&touches| touches));
    assert!(!rollout.touching[rollout.steps - GOAL_STEPS], "it ends at once");
    let outcome = Engine::Rapier.outcome(&scene([30.0, 80.0], vec![far_goal()]), None).expect("no ball to refuse");
    assert_eq!((outcome.solved, outcome.steps), (false, MAX_STEPS));
}

#[test]
fn an_invalid_ball_is_refused_for_the_same_reason() {
    let scene = scene([128.0, 80.0], vec![far_goal()]);
    let refused = |engine: Engine, ball| engine.outcome(&scene, Some(ball)).expect_err("it is invalid");
    for ball in
        [Ball { x: 128.0, y: 80.0, r: 4.0 }, Ball { x: 1.0, y: 80.0, r: 4.0 }, Ball { x: 60.0, y: 80.0, r: 99.0 }]
    {
        assert_eq!(refused(Engine::Rapier, ball), refused(Engine::Box2d, ball));
    }
    assert_eq!(refused(Engine::Rapier, Ball { x: 128.0, y: 80.0, r: 4.0 }), Invalid::Overlaps(0));
}

#[test]
fn a_rollout_is_the_same_to_the_bit_on_every_thread() {
    let tasks: Vec<Task> = ["00003:000", "00013:011", "00018:007"]
        .map(|id| Task::load(id.parse().expect("an id")).expect("a task"))
        .into();
    let digest = |task: &Task| Engine::Rapier.digest(&task.scene, None).expect("no ball to refuse");
    let alone: Vec<_> = tasks.iter().map(digest).collect();
    let threads = rayon::ThreadPoolBuilder::new().num_threads(4).build().expect("four threads");
    let together: Vec<usize> = (0..24).collect();
    let together: Vec<_> = threads.install(|| together.into_par_iter().map(|run| digest(&tasks[run % 3])).collect());
    for (run, found) in together.iter().enumerate() {
        assert_eq!(*found, alone[run % 3]);
    }
}
