//! `pathlight collect`: the same file on any number of cores, cut off or not, and nothing in it that does not solve.

use std::fs;
use std::path::Path;

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::outcome;
use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, pathlight};

/// A small search, on so many cores.
fn collect(out: &Path, cores: &str, more: &[&str]) -> String {
    let few = ["--template", "2", "--limit", "6", "--rounds", "3", "--wanted", "4"];
    let run =
        pathlight().arg("collect").args(few).args(more).arg("--out").arg(out).env("RAYON_NUM_THREADS", cores).output();
    let run = run.expect("the binary runs");
    assert!(run.status.success(), "{run:?}");
    fs::read_to_string(out).expect("the file is there")
}

#[test]
fn the_file_hangs_on_the_seed_alone_and_every_ball_in_it_solves() {
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
    assert_eq!(one, collect(&cut, "2", &[]), "cut off and gone on with");

    // What solved once solves again.
    let from = file("one").display().to_string();
    let again = collect(&file("again"), "2", &["--from", &from]);
    let known = |text: &str| text.lines().filter(|line| line.contains("ball")).count();
    assert!(known(&again) >= known(&one));
}

#[test]
fn tasks_without_a_solution_are_searched_until_they_have_one() {
    let folder = tempdir().expect("a folder");
    let out = folder.path().join("solutions.jsonl");
    let few = ["--template", "2", "--limit", "6", "--rounds", "0", "--wanted", "4"];
    let search = |persist: &str| {
        let run = pathlight().arg("collect").args(few).args(["--persist", persist]).arg("--out").arg(&out).output();
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
    assert_eq!((tasks.len(), once.len()), (6, 6), "one solution each, then they rest");
}

#[test]
fn files_that_are_not_its_own_are_refused_and_left_alone() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("letter");
    fs::write(&path, "Dear all,\n").expect("written");
    let name = path.display().to_string();
    assert_refused(&["collect", "--out", &name], "is no file of `pathlight collect`");
    assert_eq!(fs::read_to_string(&path).expect("still there"), "Dear all,\n");
    collect(&folder.path().join("own"), "2", &[]);
    let own = folder.path().join("own").display().to_string();
    assert_refused(&["collect", "--out", &own, "--seed", "5"], "name another file with --out");
}
