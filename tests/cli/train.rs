//! `pathlight train` and what is done with its weights: `publish`, `propose`, `evaluate`.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use super::{assert_refused, output_of};

/// A few solutions, collected once for all tests here.
fn solutions() -> &'static str {
    static FILE: OnceLock<(TempDir, String)> = OnceLock::new();
    let (_, file) = FILE.get_or_init(|| {
        let folder = tempdir().expect("a folder");
        let file = text(&folder.path().join("solutions.jsonl"));
        output_of(&["collect", "--template", "2", "--limit", "10", "--rounds", "2", "--per-task", "3", "--out", &file]);
        (folder, file)
    });
    file
}

/// Trains very small, in a folder; gives the path of the weights.
fn train(folder: &Path, more: &[&str]) -> PathBuf {
    let small = ["--epochs", "2", "--batch", "4", "--checkpoint", "2", "--mirror"];
    let place = ["train", "--solutions", solutions(), "--out", &text(folder)];
    output_of(&[&place[..], &small[..], more].concat());
    folder.join("weights.safetensors")
}

fn text(path: &Path) -> String {
    path.display().to_string()
}

#[test]
fn a_run_that_was_cut_off_ends_with_the_same_weights() {
    let folder = tempdir().expect("a folder");
    let whole = train(&folder.path().join("whole"), &[]);
    let cut = train(&folder.path().join("cut"), &["--stop-after", "2"]);
    assert!(!cut.exists(), "it was to stop before the end");
    let cut = train(&folder.path().join("cut"), &[]);
    assert_eq!(fs::read(whole).expect("weights"), fs::read(cut).expect("weights"));
    let losses = |run: &str| fs::read_to_string(folder.path().join(run).join("losses.csv")).expect("losses");
    assert!(losses("whole").lines().count() > 2);
    assert_eq!(losses("whole"), losses("cut"));
}

#[test]
fn another_seed_gives_other_weights_and_needs_another_folder() {
    let folder = tempdir().expect("a folder");
    let (one, two) = (folder.path().join("one"), folder.path().join("two"));
    let (first, second) = (train(&one, &[]), train(&two, &["--seed", "1"]));
    assert_ne!(fs::read(first).expect("weights"), fs::read(second).expect("weights"));
    let again = ["train", "--solutions", solutions(), "--out", &text(&one), "--seed", "1"];
    assert_refused(&again, "name another folder with --out");
}

#[test]
fn weights_are_published_proposed_from_and_refused_where_they_may_have_cheated() {
    let folder = tempdir().expect("a folder");
    let weights = text(&train(folder.path(), &[]));

    let assets = folder.path().join("assets");
    output_of(&["publish", &weights, "--assets", &text(&assets)]);
    let list: Value = serde_json::from_slice(&fs::read(assets.join("model.json")).expect("a list")).expect("JSON");
    assert_eq!(list["models"][0]["name"], "within-0");
    assert!(assets.join(list["models"][0]["file"].as_str().expect("a file")).exists());

    let propose = ["propose", "--weights", &weights, "--task", "00002:007", "--task", "00019:013", "--attempts", "30"];
    let lines = output_of(&propose);
    assert_eq!(lines, output_of(&propose), "the same seed proposes the same");
    for (line, id) in lines.lines().zip(["00002:007", "00019:013"]) {
        let line: Value = serde_json::from_str(line).expect("JSON");
        let task: TaskId = serde_json::from_value(line["task"].clone()).expect("a task");
        assert_eq!(task.to_string(), id);
        let balls: Vec<Ball> = serde_json::from_value(line["balls"].clone()).expect("balls");
        let scene = Task::load(task).expect("a task").scene;
        assert_eq!(balls.len(), 30);
        assert!(balls.iter().all(|ball| ball.check(&scene).is_ok()));
    }
    assert_eq!(lines.lines().count(), 2);

    assert_refused(&["propose", "--weights", &weights, "--fold", "1"], "trained on within 0");
    assert_refused(&["evaluate", "--weights", &weights, "--setup", "cross"], "trained on within 0");
    let missing = text(&folder.path().join("none.safetensors"));
    assert_refused(&["evaluate", "--weights", &missing], "run `pathlight train`");
}

#[test]
fn chance_is_measured_with_its_settings_beside_it() {
    let folder = tempdir().expect("a folder");
    let json = folder.path().join("random.json");
    let table = output_of(&["evaluate", "--agent", "random", "--limit", "1", "--json", &text(&json)]);
    assert!(table.starts_with("within, fold 0, 25 test tasks, seed 0, simulator "), "{table}");
    let report: Value = serde_json::from_slice(&fs::read(json).expect("a report")).expect("JSON");
    let score = &report["agents"][0];
    assert_eq!(score["agent"], "random");
    let firsts = score["first_solved"].as_array().expect("tasks");
    assert_eq!(firsts.len(), 25);
    let solved = firsts.iter().filter(|first| first[1].is_u64()).count();
    assert_eq!(score["solved_within_100"], solved as f64 / 25.0);
    assert!(table.lines().last().expect("a line").starts_with("all "), "{table}");
}
