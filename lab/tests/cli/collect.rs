//! `pathlight-lab data collect`: the same file on any number of cores, interrupted or not, holding only balls that
//! solve.

use std::fs;
use std::path::Path;

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::outcome;
use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, pathlight_lab};

/// A small search on this many cores; returns the text of the file.
fn collect(out: &Path, cores: &str, more: &[&str]) -> String {
    let few = ["--template", "2", "--limit", "6", "--rounds", "3", "--per-task", "4"];
    let run = pathlight_lab()
        .args(["data", "collect"])
        .args(few)
        .args(more)
        .arg("--out")
        .arg(out)
        .env("RAYON_NUM_THREADS", cores)
        .output();
    let run = run.expect("the binary runs");
    assert!(run.status.success(), "{run:?}");
    fs::read_to_string(out).expect("the file is there")
}

#[test]
fn the_file_depends_only_on_the_seed_and_every_ball_in_it_solves() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    let one = collect(&file("one"), "1", &[]);
    assert_eq!(one, collect(&file("two"), "2", &[]), "two cores");
    assert_ne!(one, collect(&file("seed"), "2", &["--seed", "1"]), "another seed");

    let solutions: Vec<Value> = one
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).expect("JSON"))
        .filter(|line| line.get("ball").is_some())
        .collect();
    assert!(solutions.len() >= 10, "only {} solutions to look at", solutions.len());
    for line in solutions {
        let task: TaskId = serde_json::from_value(line["task"].clone()).expect("a task");
        let ball: Ball = serde_json::from_value(line["ball"].clone()).expect("a ball");
        let scene = Task::load(task).expect("a task").scene;
        assert!(outcome(&scene, Some(ball)).expect("valid").solved, "{line}");
    }

    // Cut off in the middle of a line of the last round.
    let cut = file("cut");
    fs::write(&cut, &one[..one.len() - 60]).expect("written");
    assert_eq!(one, collect(&cut, "2", &[]), "interrupted and continued");
}

#[test]
fn a_new_file_takes_over_what_still_solves() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    let known = |text: &str| {
        let mut lines: Vec<String> = text.lines().filter(|line| line.contains("ball")).map(String::from).collect();
        lines.sort();
        lines
    };
    let one = collect(&file("one"), "2", &[]);
    // A ball that solves nothing, before those that do.
    let (settings, lines) = one.split_once('\n').expect("settings and more");
    let task = lines.lines().next().and_then(|line| line.split('"').nth(3)).expect("a task");
    let bad = format!(r#"{{"task":"{task}","ball":[3.0,3.0,2.0]}}"#);
    fs::write(file("bad"), format!("{settings}\n{bad}\n{lines}")).expect("written");
    let from = file("bad").display().to_string();
    let out = file("again").display().to_string();
    let take_over =
        ["data", "collect", "--template", "2", "--limit", "6", "--rounds", "1", "--persist", "0", "--from", &from];
    output_of(&[&take_over[..], &["--out", &out]].concat());
    // In the only round nothing is searched, so all solutions are those of the other file.
    let again = fs::read_to_string(&out).expect("the file is there");
    assert!(!known(&again).contains(&bad));
    assert_eq!(known(&again), known(&one));
    assert_refused(&[&take_over[..], &["--out", &out]].concat(), "--from is only for a new file");
}

#[test]
fn a_missing_last_newline_loses_nothing() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    // Of one round of the search for first solutions, and of many.
    let search = |out: &Path, persist: &str| {
        let few = ["--template", "2", "--limit", "6", "--rounds", "0", "--persist", persist];
        let out = out.display().to_string();
        output_of(&[&["data", "collect", "--out", &out], &few[..]].concat());
        fs::read_to_string(out).expect("the file is there")
    };
    let whole = search(&file("whole"), "500");
    let begun = search(&file("cut"), "1");
    assert!(whole.len() > begun.len());
    fs::write(file("cut"), begun.trim_end()).expect("written");
    assert_eq!(search(&file("cut"), "500"), whole);
}

#[test]
fn a_file_that_was_cut_off_in_its_first_line_is_begun_anew() {
    let folder = tempdir().expect("a folder");
    let out = folder.path().join("solutions.jsonl");
    let whole = collect(&out, "1", &[]);
    let settings = whole.lines().next().expect("the settings");
    fs::write(&out, &settings[..settings.len() / 2]).expect("written");
    assert_eq!(collect(&out, "1", &[]), whole);
}

#[test]
fn a_damaged_line_is_named_and_nothing_is_changed() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("solutions");
    let text = collect(&path, "2", &[]);
    let damaged: Vec<&str> =
        text.lines().enumerate().map(|(index, line)| if index == 4 { &line[..9] } else { line }).collect();
    let damaged = damaged.join("\n") + "\n";
    fs::write(&path, &damaged).expect("written");
    let name = path.display().to_string();
    let few = ["--template", "2", "--limit", "6", "--rounds", "3", "--per-task", "4"];
    assert_refused(&[&["data", "collect", "--out", &name], &few[..]].concat(), "line 5 of ");
    let run = folder.path().join("run").display().to_string();
    assert_refused(&["train", "paths", "--solutions", &name, "--out", &run], "line 5 of ");
    assert_refused(&["data", "label", "--solutions", &name, "--out", &run], "line 5 of ");
    assert_eq!(fs::read_to_string(&path).expect("still there"), damaged);
}

#[test]
fn tasks_without_a_solution_are_searched_until_they_have_one() {
    let folder = tempdir().expect("a folder");
    let out = folder.path().join("solutions.jsonl");
    let few = ["--template", "2", "--limit", "6", "--rounds", "0", "--per-task", "4"];
    let search = |persist: &str| {
        let run = pathlight_lab()
            .args(["data", "collect"])
            .args(few)
            .args(["--persist", persist])
            .arg("--out")
            .arg(&out)
            .output();
        let text = fs::read_to_string(&out).expect("the file is there");
        let lines = text.lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
        let mut tasks: Vec<String> = lines.filter_map(|line| line["task"].as_str().map(String::from)).collect();
        tasks.sort();
        (String::from_utf8(run.expect("the binary runs").stdout).expect("UTF-8"), tasks)
    };
    let (said, tasks) = search("0");
    assert!(tasks.is_empty() && said.contains("6 have none"), "{said}");
    let (said, tasks) = search("500");
    assert!(said.contains("0 have none"), "{said}");
    let mut once = tasks.clone();
    once.dedup();
    assert_eq!((tasks.len(), once.len()), (6, 6), "each task stops at its first solution");
}

#[test]
fn files_that_are_not_its_own_are_refused_and_left_alone() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("letter");
    fs::write(&path, "Dear all,\n").expect("written");
    let name = path.display().to_string();
    assert_refused(&["data", "collect", "--out", &name], "is not a file of `pathlight-lab data collect`");
    assert_eq!(fs::read_to_string(&path).expect("still there"), "Dear all,\n");
    fs::write(&path, vec![b' '; 1 << 21]).expect("written");
    assert_refused(&["data", "collect", "--out", &name], "line 1 of ");
    collect(&folder.path().join("own"), "2", &[]);
    let own = folder.path().join("own").display().to_string();
    let refused = |more: &[&str], words: &str| {
        let few =
            ["data", "collect", "--template", "2", "--limit", "6", "--rounds", "3", "--per-task", "4", "--out", &own];
        assert_refused(&[&few[..], more].concat(), words);
    };
    refused(&["--seed", "5"], "`seed` is 0 instead of 5): write to another file with --out");
    let other = ["data", "collect", "--rounds", "3", "--per-task", "4", "--out", &own];
    assert_refused(&other, "`limit` is 6 instead of 100, `template` is 2 instead of none");
}
