//! Custom scenes on the command line, and verified attempts: `tasks`, `simulate`, `propose` and `verify`.

use std::fs;

use serde_json::Value;

use crate::{assert_refused, output_of, run, stderr, stdout, without_line};

const TASK: &str = "00000:002";

/// A folder with the custom scene of a task in `scene.json`.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("scene.json"), output_of(&["tasks", "--custom", TASK])).expect("written");
    folder
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn the_shipped_schema_is_that_of_the_types() {
    let shipped = include_str!("../../assets/scene.schema.json");
    assert_eq!(output_of(&["tasks", "--schema"]), shipped, "pathlight tasks --schema > assets/scene.schema.json");
}

#[test]
fn a_custom_scene_runs_like_the_task_that_it_was_made_of() {
    let folder = folder();
    let file = folder.path().join("scene.json");
    let file = file.to_str().expect("a path");
    let (custom, task) =
        (parsed(&output_of(&["tasks", "--scene", file])), parsed(&output_of(&["tasks", "--json", TASK])));
    for key in ["goal", "body1", "body2", "bodies"] {
        assert_eq!(custom[key], task[key], "{key}: every number comes back to the last bit");
    }
    let simulated =
        |args: &[&str]| parsed(&output_of(&[&["simulate", "--ball", "128,240,9", "--poses"], args].concat()));
    let (custom, task) = (simulated(&["--scene", file]), simulated(&["--task", TASK]));
    assert_eq!((&custom["status"], &custom["poses"]), (&task["status"], &task["poses"]));
    assert_eq!(custom.get("task"), None);
}

#[test]
fn a_scene_that_may_not_be_played_is_refused_with_all_reasons() {
    let folder = folder();
    let path = folder.path().join("scene.json");
    let file = path.to_str().expect("a path");
    let mut scene = parsed(&fs::read_to_string(&path).expect("read"));
    scene["bodies"][0]["radius"] = 99.into();
    scene["bodies"][1]["angle"] = 9.into();
    fs::write(&path, scene.to_string()).expect("written");
    assert_refused(&["simulate", "--scene", file], "The radius of the green ball (body 0) is 99.0 px");
    assert_refused(&["simulate", "--scene", file], "(body 1) has no valid place");
    fs::write(&path, "{").expect("written");
    assert_refused(&["simulate", "--scene", file], "scene.json");
}

#[test]
fn a_scene_comes_from_standard_input_too_and_a_task_is_refused_with_the_remedy() {
    let simulated = |kind: &str| run(&["simulate", "--scene", "-"], &output_of(&["tasks", kind, TASK]));
    let custom = simulated("--custom");
    assert!(custom.status.success(), "{}", stderr(&custom));
    let task = simulated("--json");
    assert_eq!((task.status.code(), stdout(&task)), (Some(2), String::new()));
    assert!(stderr(&task).contains("use `pathlight tasks --custom`"), "{}", stderr(&task));
    let endless = run(&["simulate", "--scene", "-"], &" ".repeat(3 << 20));
    assert!(stderr(&endless).contains("- is larger than 1048576 bytes"), "{}", stderr(&endless));
}

#[test]
fn a_batch_takes_custom_scenes_beside_tasks() {
    let folder = folder();
    let path = folder.path().join("scene.json");
    let file = path.to_str().expect("a path");
    let scene = fs::read_to_string(&path).expect("read");
    let lines = format!(
        "{}\n{}\n{}\n",
        format_args!(r#"{{"scene":{},"ball":[128,240,9]}}"#, scene.trim()),
        format_args!(r#"{{"task":"{TASK}","ball":[128,240,9]}}"#),
        format_args!(r#"{{"scene":{},"ball":null}}"#, scene.trim()),
    );
    for flags in [&[][..], &["--paths"], &["--verifiable"]] {
        let batch = run(&[&["simulate", "--batch", "-"], flags].concat(), &lines);
        assert_eq!(batch.status.code(), Some(0), "{batch:?}");
        let one = |args: &[&str]| output_of(&[&["simulate"], args, flags].concat());
        let expected = [
            one(&["--scene", file, "--ball", "128,240,9"]),
            one(&["--task", TASK, "--ball", "128,240,9"]),
            one(&["--scene", file]),
        ];
        if flags == ["--verifiable"] {
            assert_eq!(stdout(&batch), expected.concat());
            continue;
        }
        for (line, (answer, expected)) in (1..).zip(stdout(&batch).lines().zip(&expected)) {
            assert_eq!(without_line(line, answer), parsed(expected));
        }
    }
    let bad = run(&["simulate", "--batch", "-"], r#"{"scene":{"version":1},"ball":null}"#);
    assert_eq!(bad.status.code(), Some(2));
    assert!(stderr(&bad).contains("error: line 1: "), "{}", stderr(&bad));
}

#[test]
fn an_action_that_places_no_ball_is_an_invalid_line_that_verifies() {
    let flags = ["--action", "0.5,1.5,0", "--verifiable"];
    let single = output_of(&[&["simulate", "--task", TASK][..], &flags].concat());
    let line = parsed(&single);
    assert_eq!((&line["status"], &line["ball"], &line["steps"]), (&"invalid".into(), &Value::Null, &0.into()));
    let request = format!(r#"{{"task":"{TASK}","action":[0.5,1.5,0]}}"#);
    assert_eq!(stdout(&run(&["simulate", "--batch", "-", "--verifiable"], &request)), single);
    assert_eq!(run(&["verify", "-"], &single).status.code(), Some(0));
}

#[test]
fn verify_tells_same_from_other_and_not_valid() {
    let folder = folder();
    let file = folder.path().join("scene.json");
    let of = |args: &[&str]| output_of(&[&["simulate", "--verifiable", "--ball", "128,240,9"], args].concat());
    let same = of(&["--task", TASK]) + &of(&["--scene", file.to_str().expect("a path")]);
    let verified = |lines: &str| {
        let output = run(&["verify", "-"], lines);
        let verdicts = stdout(&output).lines().map(|line| parsed(line)["verdict"].clone()).collect::<Vec<_>>();
        (output.status.code(), verdicts)
    };
    assert_eq!(verified(&same), (Some(0), vec!["same".into(), "same".into()]));
    let mut line = parsed(same.lines().next().expect("a line"));
    line["digest"] = "0".repeat(16).into();
    let other = format!("{same}{line}\n");
    assert_eq!(verified(&other), (Some(1), vec!["same".into(), "same".into(), "other_outcome".into()]));
    assert_eq!(verified(&format!("{line}\nsoup\n")), (Some(2), vec!["other_outcome".into(), "not_valid".into()]));
    for digest in ["0".repeat(15), "A".repeat(16)] {
        line["digest"] = digest.into();
        assert_eq!(verified(&line.to_string()), (Some(2), vec!["not_valid".into()]), "{line}");
    }
    line["digest"] = "0".repeat(16).into();
    line["ball"] = serde_json::json!([1, 1, 30]);
    assert_eq!(verified(&line.to_string()), (Some(2), vec!["not_valid".into()]));
    assert_refused(&["verify", "-"], "no attempts");
}
