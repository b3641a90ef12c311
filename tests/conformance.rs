//! Every task is PHYRE's: same bodies in the same order, same roles, goal and parameters, same coordinates.
//!
//! The first test compares all 2,500 with PHYRE's own. That data is no part of the project: PATHLIGHT_PHYRE
//! names the folder that has `tasks/00000.jsonl` and so on; without it the test says so and checks nothing.
//! The second needs no data: it holds one digest per template, taken when all scenes conformed.
#![cfg(not(target_arch = "wasm32"))]

use std::{env, fs, path::Path};

use md5::{Digest, Md5};
use pathlight::puzzle::scene::{Body, Part, Role, Shape};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use serde::Deserialize;
use serde_json::{Map, Value};

/// How far a coordinate (px) or an angle (rad) may be off. The reference has six decimals.
const TOLERANCE: f64 = 1e-4;

#[derive(Deserialize)]
struct Reference {
    id: TaskId,
    params: Map<String, Value>,
    body1: usize,
    body2: usize,
    goal: String,
    bodies: Vec<ReferenceBody>,
}

#[derive(Deserialize)]
struct ReferenceBody {
    shape: Shape,
    color: Role,
    dynamic: bool,
    x: f64,
    y: f64,
    angle: f64,
    parts: Vec<Part>,
}

#[test]
fn every_scene_is_phyres() {
    let Some(folder) = env::var_os("PATHLIGHT_PHYRE") else {
        println!("skipped: PATHLIGHT_PHYRE does not name a folder with PHYRE's tasks");
        return;
    };
    let (mut conforming, mut different) = (0, Vec::new());
    for template in TEMPLATES {
        let path = Path::new(&folder).join(format!("tasks/{:05}.jsonl", template.number));
        let lines = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let references: Vec<Reference> = lines
            .lines()
            .map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{}: {error}", path.display())))
            .collect();
        let tasks: Vec<Task> = Task::of(template).collect();
        assert_eq!(tasks.len(), references.len(), "tasks of {}", template.name);
        for (task, reference) in tasks.iter().zip(&references) {
            match difference(task, reference) {
                None => conforming += 1,
                Some(what) => different.push(format!("{} {what}", reference.id)),
            }
        }
    }
    println!("{conforming} of {} scenes conform", conforming + different.len());
    assert!(different.is_empty(), "{} differ:\n{}", different.len(), different.join("\n"));
    assert_eq!(conforming, 2500);
}

/// What is different about the task, if anything.
fn difference(task: &Task, reference: &Reference) -> Option<String> {
    let scene = &task.scene;
    let goal = (&task.goal, scene.body1, scene.body2);
    let expected = (&reference.goal, reference.body1, reference.body2);
    if task.id != reference.id {
        return Some(format!("is {} here", task.id));
    }
    if goal != expected {
        return Some(format!("has the goal {goal:?}, expected {expected:?}"));
    }
    if !same_params(&task.params, &reference.params) {
        return Some(format!("has the parameters {:?}, expected {:?}", task.params, reference.params));
    }
    if scene.bodies.len() != reference.bodies.len() {
        return Some(format!("has {} bodies, expected {}", scene.bodies.len(), reference.bodies.len()));
    }
    let mut pairs = scene.bodies.iter().zip(&reference.bodies);
    let body = pairs.position(|(body, expected)| !same_body(body, expected))?;
    Some(format!("differs in body {body}: {:?}", scene.bodies[body]))
}

/// Equal, numbers within a billionth.
fn same_params(params: &Map<String, Value>, expected: &Map<String, Value>) -> bool {
    let same = |value: &Value, expected: &Value| match (value.as_f64(), expected.as_f64()) {
        (Some(value), Some(expected)) => (value - expected).abs() <= 1e-9,
        _ => value == expected,
    };
    params.keys().eq(expected.keys()) && params.iter().all(|(name, value)| same(value, &expected[name]))
}

fn same_body(body: &Body, expected: &ReferenceBody) -> bool {
    let close = |a: f64, b: f64| (a - b).abs() <= TOLERANCE;
    let same_part = |part: &Part, expected: &Part| match (part, expected) {
        (Part::Circle(radius), Part::Circle(expected)) => close(*radius, *expected),
        (Part::Polygon(corners), Part::Polygon(expected)) => {
            corners.len() == expected.len()
                && corners.iter().zip(expected).all(|(a, b)| close(a[0], b[0]) && close(a[1], b[1]))
        }
        _ => false,
    };
    (body.shape, body.role, body.dynamic) == (expected.shape, expected.color, expected.dynamic)
        && close(body.x, expected.x)
        && close(body.y, expected.y)
        && close(body.angle, expected.angle)
        && body.parts.len() == expected.parts.len()
        && body.parts.iter().zip(&expected.parts).all(|(part, expected)| same_part(part, expected))
}

#[test]
fn every_scene_is_as_it_was() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/scenes.txt");
    let digests: String =
        TEMPLATES.iter().map(|template| format!("{:05} {}\n", template.number, digest(Task::of(template)))).collect();
    if env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, &digests).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let golden = fs::read_to_string(&path).unwrap_or_default();
    let changed: Vec<&str> =
        digests.lines().filter(|now| !golden.lines().any(|then| then == *now)).map(|now| &now[..5]).collect();
    assert!(
        digests == golden,
        "the scenes of templates {changed:?} are not those of tests/golden/scenes.txt. If that is meant, run \
         `UPDATE_GOLDEN=1 cargo test --release --test conformance` with PATHLIGHT_PHYRE set and look at the diff"
    );
}

/// MD5 over the ids, goals, bodies and coordinates of the tasks, as hex.
fn digest(tasks: impl Iterator<Item = Task>) -> String {
    let mut md5 = Md5::new();
    for task in tasks {
        let scene = &task.scene;
        md5.update(format!("{} {} {} {}\n", task.id, task.goal, scene.body1, scene.body2));
        for Body { x, y, angle, dynamic, shape, role, parts } in &scene.bodies {
            let pose = [x, y, angle].map(|&at| rounded(at));
            md5.update(format!("{shape:?} {role:?} {dynamic} {pose:?}\n"));
            for part in parts {
                match part {
                    Part::Circle(radius) => md5.update(format!("{}\n", rounded(*radius))),
                    Part::Polygon(corners) => {
                        let corners: Vec<_> = corners.iter().map(|corner| corner.map(rounded)).collect();
                        md5.update(format!("{corners:?}\n"));
                    }
                }
            }
        }
    }
    md5.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// In ten-thousandths. The odd offset keeps decimal fractions away from the steps, so that an error in the
/// last place does not show.
fn rounded(value: f64) -> i64 {
    (value * 1e4 + std::f64::consts::FRAC_1_PI).floor() as i64
}
