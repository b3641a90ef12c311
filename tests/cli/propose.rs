//! `pathlight propose`: the same balls for the same seed, and a file that is written only once it is complete.

use std::fs;

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of};

#[test]
fn balls_are_proposed_and_weights_refused_on_folds_they_may_have_seen() {
    let folder = tempdir().expect("a folder");
    let propose = ["propose", "--task", "00002:007", "--task", "00019:013", "--attempts", "30"];
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
    let out = folder.path().join("new/proposals.jsonl").display().to_string();
    output_of(&[&propose[..], &["--out", &out]].concat());
    let lacking = [&propose[..], &["--out", &out, "--task", "00000:999"]].concat();
    assert_refused(&lacking, "task 00000:999 is not in the benchmark");
    assert_eq!(fs::read_to_string(&out).expect("a file"), lines, "it stays until the new one is complete");

    let weights = "assets/within-0.safetensors";
    assert_refused(&["propose", "--weights", weights, "--fold", "1"], "trained on within 0");
    // The dynamics net of this model has seen no task, but its other nets belong to fold 0.
    let of_random_scenes = ["--weights", "assets/cross-0.safetensors", "--setup", "cross", "--fold", "1"];
    let proposed = output_of(&[&["propose", "--task", "00000:000"], &of_random_scenes[..]].concat());
    assert!(proposed.starts_with("{\"task\":"), "{proposed}");
    assert_refused(&[&["agent", "--agent", "paper"], &of_random_scenes[..]].concat(), "trained on cross 0");
    let missing = folder.path().join("none.safetensors").display().to_string();
    assert_refused(&["propose", "--weights", &missing], "a file from `pathlight-lab train`");
}
