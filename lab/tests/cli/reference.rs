//! `pathlight-lab measure fidelity`, on a few lines of reference data made by the test, and `data difficulty`.

use std::fs;
use std::path::Path;

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, ids};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{digest, outcome};
use serde_json::{Value, json};
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

/// Makes a reference folder with one outcome per kind of ball, all of this simulator.
fn reference(folder: &Path) -> String {
    let task = Task::load(ids(TEMPLATES[0]).next().expect("a task")).expect("a task");
    // A grid of balls has some that solve and some that do not.
    let balls = (0..400).map(|index| Ball {
        x: f64::from(10 * (index % 20) + 30),
        y: f64::from(10 * (index / 20) + 30),
        r: 12.0,
    });
    let tried: Vec<(Ball, bool)> =
        balls.filter_map(|ball| Some((ball, outcome(&task.scene, Some(ball)).ok()?.solved))).collect();
    let first = |solved| tried.iter().find(|(_, found)| *found == solved).expect("both outcomes").0;
    let line = |ball: Ball, kind: &str, solved: bool| {
        let (_, digest) = digest(&task.scene, Some(ball)).expect("a valid ball");
        json!({"task": task.id, "ball": ball, "kind": kind, "solved": solved, "digest": digest.to_string()}).to_string()
    };
    let outcomes = [
        line(first(true), "stable", true),
        line(first(false), "random", false),
        // A false claim, so that not everything agrees.
        line(first(false), "unstable", true),
    ];
    fs::write(folder.join("outcomes.jsonl"), outcomes.join("\n")).expect("written");
    folder.display().to_string()
}

#[test]
fn agreement_is_counted() {
    let folder = tempdir().expect("a folder");
    let text = output_of(&["measure", "fidelity", "--reference", &reference(folder.path())]);
    let row = |name: &str| -> Vec<String> {
        let line = text.lines().find(|line| line.starts_with(name)).unwrap_or_else(|| panic!("{name}: {text}"));
        line[name.len()..].split_whitespace().map(String::from).collect()
    };
    // Same bits, same outcome, of how many: stable, unstable, random that fail, random that solve.
    assert_eq!(row("all ").join(" "), "100.00 100.00 (1) 100.00 0.00 (1) 100.00 100.00 (1) - - (0)");

    // The other engine is compared with the first.
    let both =
        output_of(&["measure", "fidelity", "--engine", "rapier", "--reference", &folder.path().display().to_string()]);
    let (first, other) = both.split_once("Engine rapier").expect("a heading");
    assert_eq!(first.trim(), format!("Engine box2d\n\n{}", text.trim()));
    assert_eq!(other.lines().filter(|line| line.starts_with("all ")).count(), 1);

    fs::write(folder.path().join("outcomes.jsonl"), "{}").expect("written");
    assert_refused(
        &["measure", "fidelity", "--reference", &folder.path().display().to_string()],
        "outcomes.jsonl, line 1",
    );
    assert_refused(&["measure", "fidelity", "--reference", "no/such/folder"], "name its folder with --reference");
}

#[test]
fn the_shipped_counts_of_solving_balls_are_those_that_are_counted() {
    let counted: Value = serde_json::from_str(&output_of(&["data", "difficulty", "--limit", "1"])).expect("JSON");
    let shipped: Value =
        serde_json::from_str(&fs::read_to_string(root("src/benchmark/difficulty.json")).expect("shipped"))
            .expect("JSON");
    for key in ["simulator", "seed", "balls"] {
        assert_eq!(counted[key], shipped[key], "{key}");
    }
    let firsts = |difficulty: &Value| {
        let templates = difficulty["solved"].as_array().expect("a list of templates");
        templates.iter().map(|tasks| tasks[0].as_u64().expect("a count")).collect::<Vec<_>>()
    };
    assert_eq!(firsts(&counted), firsts(&shipped), "the first task of each template");
    assert_eq!(firsts(&shipped).len(), 25);
    assert_refused(&["data", "difficulty", "--balls", "0"], "0 is not in");
}
