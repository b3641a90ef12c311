//! The contract of the simulator: the content of a rollout, the three seconds of the goal, refusal of invalid balls,
//! and PHYRE's rollouts.
//!
//! The last test needs PHYRE's recorded rollouts, which are not part of the project: PATHLIGHT_PHYRE names the folder
//! with outcomes.jsonl, and `--include-ignored` runs the test. `pathlight-lab measure fidelity` prints more.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::BTreeMap;
use std::{env, fs, path::Path};

use pathlight::puzzle::action::{Ball, Invalid, Obstacles};
use pathlight::puzzle::rollout::{GOAL_STEPS, MAX_STEPS};
use pathlight::puzzle::sampling::uniform_ball;
use pathlight::puzzle::scene::{Body, Role, Scene, Shape, ShapeType};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{self, ContactEvent, Outcome, contacts, outcome, simulate};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use serde::Deserialize;

/// A green ball and a blue one, both with a radius of 10 px, at these places.
fn two_balls(green: [f64; 2], blue: [f64; 2]) -> Scene {
    let ball = |[x, y]: [f64; 2], role| Body {
        x,
        y,
        angle: 0.0,
        dynamic: true,
        shape_type: ShapeType::Ball,
        role,
        shapes: vec![Shape::Circle(10.0)],
    };
    Scene { body1: 0, body2: 1, bodies: vec![ball(green, Role::Green), ball(blue, Role::Blue)] }
}

#[test]
fn a_ball_falls_with_gravity_and_comes_to_rest() {
    let rollout = simulate(&two_balls([50.0, 200.0], [200.0, 200.0]), None).expect("no ball to refuse");
    assert_eq!((rollout.solved, rollout.steps), (false, MAX_STEPS));
    assert_eq!(rollout.poses.len(), (MAX_STEPS + 1) * 2);
    assert_eq!(rollout.touching.len(), MAX_STEPS + 1);
    for step in 0..60 {
        // 9.8 m/s^2 at 6 px/m; each step of 1/60 s first gains speed, then moves.
        let expected = 200.0 - 9.8 * 6.0 / 3600.0 * (step * (step + 1)) as f32 / 2.0;
        let [x, y, angle] = rollout.row(step)[0];
        assert!((y - expected).abs() < 1e-2 && x == 50.0 && angle == 0.0, "step {step}: {x} {y} {angle}");
    }
    // Rest position: the radius and the polygon skin of 0.06 px above the floor, minus the slop.
    let [_, y, _] = rollout.row(MAX_STEPS)[0];
    assert!((10.02..10.07).contains(&y), "rests at {y}");
    assert_eq!(rollout.row(MAX_STEPS), rollout.row(MAX_STEPS - 100));
}

#[test]
fn the_task_is_solved_after_three_seconds_of_contact() {
    let rollout = simulate(&two_balls([50.0, 10.05], [70.0, 10.05]), None).expect("no ball to refuse");
    assert_eq!((rollout.solved, rollout.steps), (true, GOAL_STEPS));
    assert!(rollout.touching.iter().all(|&touches| touches));
    let apart = outcome(&two_balls([50.0, 10.05], [90.0, 10.05]), None).expect("no ball to refuse");
    assert_eq!((apart.solved, apart.steps), (false, MAX_STEPS));
}

/// Without poses, a rollout ends as soon as its outcome is certain.
#[test]
fn an_outcome_is_that_of_the_whole_rollout() {
    let mut rng = Pcg64Mcg::seed_from_u64(3);
    let mut solved = 0;
    for task in TEMPLATES.iter().flat_map(|template| Task::of(template).step_by(33)) {
        let obstacles = Obstacles::new(&task.scene);
        for _ in 0..12 {
            let ball = uniform_ball(&obstacles, &mut rng);
            let rollout = simulate(&task.scene, ball).expect("a valid ball");
            let Outcome { solved: solves, steps } = outcome(&task.scene, ball).expect("a valid ball");
            assert_eq!((solves, steps), (rollout.solved, rollout.steps), "{}, {ball:?}", task.id);
            solved += usize::from(solves);
        }
    }
    assert!(solved > 10, "only {solved} balls solve");
}

#[test]
fn an_invalid_ball_is_refused() {
    let scene = two_balls([50.0, 50.0], [200.0, 50.0]);
    assert_eq!(simulate(&scene, Some(Ball { x: 55.0, y: 50.0, r: 5.0 })).err(), Some(Invalid::Overlaps(0)));
    assert_eq!(outcome(&scene, Some(Ball { x: 2.0, y: 50.0, r: 5.0 })).err(), Some(Invalid::Outside));
}

#[test]
fn the_action_ball_comes_last() {
    let scene = two_balls([50.0, 50.0], [200.0, 50.0]);
    let rollout = simulate(&scene, Some(Ball { x: 120.0, y: 100.0, r: 8.0 })).expect("a valid ball");
    assert_eq!(rollout.bodies, [0, 1, 2]);
    assert_eq!(rollout.row(0)[2], [120.0, 100.0, 0.0]);
}

#[test]
fn contacts_begin_when_bodies_meet_and_end_when_they_part() {
    let scene = two_balls([50.0, 200.0], [200.0, 200.0]);
    let ball = Ball { x: 50.0, y: 240.0, r: 8.0 };
    let rollout = simulate(&scene, Some(ball)).expect("a valid ball");
    let contacts = contacts(&scene, Some(ball)).expect("a valid ball");
    // The scene's two balls, the action ball, then the walls, the first of which is the floor.
    let [green, blue, red, floor] = [0, 1, 2, 3];
    assert!(contacts.is_sorted_by_key(|contact| contact.begin));
    let of = |bodies| contacts.iter().filter(move |contact| contact.bodies == bodies).collect::<Vec<_>>();
    // The blue ball bounces, then rests to the end.
    let [first, .., last] = of([blue, floor])[..] else { panic!("it bounces: {contacts:?}") };
    let lowest = (1..).find(|&step| rollout.row(step)[blue][1] < 10.1).expect("it falls");
    assert_eq!((first.begin - 1, last.end), (lowest, MAX_STEPS + 1));
    assert!(of([blue, floor]).is_sorted_by(|one, next| one.end < next.begin), "{contacts:?}");
    // The red ball falls on the green one, which is already lying on the floor.
    let hit = of([green, red])[0];
    let [x, y] = [0, 1].map(|axis| rollout.row(hit.begin)[red][axis] - rollout.row(hit.begin)[green][axis]);
    assert!(x.hypot(y) < 18.1 && hit.begin > lowest, "{hit:?}: {x} {y}");
    assert_eq!(of([green, blue]), [] as [&ContactEvent; 0]);
}

/// Except for two balls, where touching the goal has another definition.
#[test]
fn contacts_of_the_goal_are_its_touches() {
    let mut rng = Pcg64Mcg::seed_from_u64(5);
    let mut touches = 0;
    for task in TEMPLATES.iter().flat_map(|template| Task::of(template).step_by(11)) {
        let Scene { body1, body2, bodies } = &task.scene;
        if [body1, body2].iter().all(|&&body| bodies[body].ball_radius().is_some()) {
            continue;
        }
        let ball = uniform_ball(&Obstacles::new(&task.scene), &mut rng);
        let rollout = simulate(&task.scene, ball).expect("a valid ball");
        let contacts = contacts(&task.scene, ball).expect("a valid ball");
        let goal = [*body1.min(body2), *body1.max(body2)];
        let of_goal: Vec<_> = contacts.iter().filter(|contact| contact.bodies == goal).collect();
        let touching = |step| of_goal.iter().any(|contact| (contact.begin..contact.end).contains(&step));
        assert!((0..=rollout.steps).all(|step| rollout.touching[step] == touching(step)), "{}, {ball:?}", task.id);
        touches += of_goal.len();
    }
    assert!(touches > 40, "only {touches} contacts");
}

/// A line of outcomes.jsonl.
#[derive(Deserialize)]
struct Recorded {
    task: TaskId,
    ball: Ball,
    /// The outcome that PHYRE recorded, or that of its Box2D for a random ball.
    solved: bool,
    /// Steps and digest of its Box2D, and its outcome if that differs from the recorded one.
    steps: usize,
    digest: String,
    reference_solved: Option<bool>,
}

#[test]
#[ignore = "needs PATHLIGHT_PHYRE"]
fn every_recorded_rollout_is_phyres_to_the_bit() {
    let folder = env::var_os("PATHLIGHT_PHYRE").expect("PATHLIGHT_PHYRE names the folder with PHYRE's outcomes");
    let path = Path::new(&folder).join("outcomes.jsonl");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let scenes: BTreeMap<TaskId, Scene> =
        TEMPLATES.into_iter().flat_map(Task::of).map(|task| (task.id, task.scene)).collect();
    let lines: Vec<&str> = text.lines().collect();
    let differs = |line: &&&str| {
        let Recorded { task, ball, solved, steps, digest, reference_solved } =
            serde_json::from_str(line).expect("a line of outcomes.jsonl");
        let (outcome, found) = simulator::digest(&scenes[&task], Some(ball)).expect("a valid ball");
        let expected = Outcome { solved: reference_solved.unwrap_or(solved), steps };
        (outcome, found.to_string()) != (expected, digest)
    };
    let different: Vec<&&str> = lines.par_iter().filter(differs).collect();
    assert!(lines.len() > 30_000, "only {} lines", lines.len());
    assert!(different.is_empty(), "{} of {}, the first {}", different.len(), lines.len(), different[0]);
}
