//! Every task is PHYRE's: same bodies in the same order, same roles, goal and parameters, same coordinates.
//!
//! The first test compares all tasks with PHYRE's own data, which are not part of the project: PATHLIGHT_PHYRE names
//! the folder with `tasks/00000.jsonl` and so on, and `--include-ignored` runs the test. The second test needs no data.
//! It compares with one digest per template, taken when all scenes conformed.
#![cfg(not(target_arch = "wasm32"))]

use std::{env, fs, path::Path};

use md5::{Digest, Md5};
use pathlight::puzzle::scene::{Body, Role, Shape, ShapeType};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::{TASKS, TEMPLATES};
use serde::Deserialize;
use serde_json::{Map, Value};

/// Tolerance of a coordinate (px) or an angle (rad). The reference has six decimals.
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
    #[serde(rename = "shape")]
    shape_type: ShapeType,
    color: Role,
    dynamic: bool,
    x: f64,
    y: f64,
    angle: f64,
    #[serde(rename = "parts")]
    shapes: Vec<Shape>,
}

#[test]
#[ignore = "needs PATHLIGHT_PHYRE"]
fn every_scene_is_phyres() {
    let folder = env::var_os("PATHLIGHT_PHYRE").expect("PATHLIGHT_PHYRE names the folder with PHYRE's tasks");
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
    assert_eq!(conforming, TEMPLATES.len() * TASKS);
}

/// Describes the difference between the task and PHYRE's.
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

/// Returns whether the parameters are equal, numbers to within 1e-9.
fn same_params(params: &Map<String, Value>, expected: &Map<String, Value>) -> bool {
    let same = |value: &Value, expected: &Value| match (value.as_f64(), expected.as_f64()) {
        (Some(value), Some(expected)) => (value - expected).abs() <= 1e-9,
        _ => value == expected,
    };
    params.keys().eq(expected.keys()) && params.iter().all(|(name, value)| same(value, &expected[name]))
}

fn same_body(body: &Body, expected: &ReferenceBody) -> bool {
    let close = |a: f64, b: f64| (a - b).abs() <= TOLERANCE;
    let same_shape = |shape: &Shape, expected: &Shape| match (shape, expected) {
        (Shape::Circle(radius), Shape::Circle(expected)) => close(*radius, *expected),
        (Shape::Polygon(corners), Shape::Polygon(expected)) => {
            corners.len() == expected.len()
                && corners.iter().zip(expected).all(|(a, b)| close(a[0], b[0]) && close(a[1], b[1]))
        }
        _ => false,
    };
    (body.shape_type, body.role, body.dynamic) == (expected.shape_type, expected.color, expected.dynamic)
        && close(body.x, expected.x)
        && close(body.y, expected.y)
        && close(body.angle, expected.angle)
        && body.shapes.len() == expected.shapes.len()
        && body.shapes.iter().zip(&expected.shapes).all(|(shape, expected)| same_shape(shape, expected))
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

/// Returns the MD5 of the ids, goals, bodies and coordinates of the tasks, as hex.
fn digest(tasks: impl Iterator<Item = Task>) -> String {
    let mut md5 = Md5::new();
    for task in tasks {
        let scene = &task.scene;
        md5.update(format!("{} {} {} {}\n", task.id, task.goal, scene.body1, scene.body2));
        for Body { x, y, angle, dynamic, shape_type, role, shapes } in &scene.bodies {
            let pose = [x, y, angle].map(|&at| rounded(at));
            md5.update(format!("{shape_type:?} {role:?} {dynamic} {pose:?}\n"));
            for shape in shapes {
                match shape {
                    Shape::Circle(radius) => md5.update(format!("{}\n", rounded(*radius))),
                    Shape::Polygon(corners) => {
                        let corners: Vec<_> = corners.iter().map(|corner| corner.map(rounded)).collect();
                        md5.update(format!("{corners:?}\n"));
                    }
                }
            }
        }
    }
    md5.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Rounds to ten-thousandths. The irrational offset keeps decimal fractions away from the rounding steps, so that an
/// error in the last place does not change the digest.
fn rounded(value: f64) -> i64 {
    (value * 1e4 + std::f64::consts::FRAC_1_PI).floor() as i64
}
