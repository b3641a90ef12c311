//! `pathlight-lab data collect`: the same file on any number of cores, interrupted or not, holding only balls that
//! solve.

use std::fs;
use std::path::Path;

use pathlight::puzzle::task::Task;
use pathlight::simulator::outcome;
use pathlight_lab::data::solutions::TaskSolutions;
use tempfile::tempdir;

use super::{assert_refused, output_of, pathlight_lab};

/// Runs a small search on this many cores; returns the text of the file.
fn collect(out: &Path, cores: &str, more: &[&str]) -> String {
    let few = ["--template", "2", "--limit", "20", "--per-task", "2"];
    let mut command = pathlight_lab();
    command.args(["data", "collect"]).args(few).args(more).arg("--out").arg(out);
    let run = command.env("RAYON_NUM_THREADS", cores).output().expect("the binary runs");
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

    let tasks: Vec<TaskSolutions> =
        one.lines().skip(1).map(|line| serde_json::from_str(line).expect("a line of a task")).collect();
    assert_eq!(tasks.len(), 20);
    for TaskSolutions { task, balls, .. } in tasks {
        let scene = Task::load(task).expect("a task").scene;
        assert_eq!(balls.len(), 2, "{task}");
        for ball in balls {
            assert!(outcome(&scene, Some(ball)).expect("valid").solved, "{task}: {ball}");
        }
    }

    // Cut off in the middle of a line.
    let cut = file("cut");
    fs::write(&cut, &one[..one.len() - 60]).expect("written");
    assert_eq!(one, collect(&cut, "2", &[]), "interrupted and continued");
}

/// Editors and PowerShell save files in these encodings.
#[test]
fn a_byte_order_mark_is_skipped_and_utf16_is_named() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    let whole = collect(&file("whole"), "2", &[]);
    let marked = format!("\u{feff}{whole}");
    fs::write(file("marked"), &marked[..marked.len() - 60]).expect("written");
    assert_eq!(collect(&file("marked"), "2", &[]), marked, "continued");
    let [marked, utf16, out] = ["marked", "utf16", "out"].map(|name| file(name).display().to_string());
    let label = ["data", "label", "--template", "2", "--limit", "2", "--rounds", "1", "--out", &out, "--solutions"];
    output_of(&[&label[..], &[&marked]].concat());
    fs::write(&utf16, whole.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>()).expect("written");
    for command in [&["data", "collect", "--out"][..], &label] {
        assert_refused(&[command, &[&utf16]].concat(), "this is UTF-16: save it as UTF-8");
    }
}

#[test]
fn a_missing_last_newline_loses_nothing() {
    let folder = tempdir().expect("a folder");
    let whole = collect(&folder.path().join("whole"), "2", &[]);
    let cut = folder.path().join("cut");
    let begun: Vec<&str> = whole.lines().take(9).collect();
    fs::write(&cut, begun.join("\n")).expect("written");
    assert_eq!(collect(&cut, "2", &[]), whole);
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
    let few = ["--template", "2", "--limit", "20", "--per-task", "2"];
    assert_refused(&[&["data", "collect", "--out", &name], &few[..]].concat(), "line 5 of ");
    let run = folder.path().join("run").display().to_string();
    assert_refused(&["train", "paths", "--solutions", &name, "--out", &run], "line 5 of ");
    assert_refused(&["data", "label", "--solutions", &name, "--out", &run], "line 5 of ");
    assert_eq!(fs::read_to_string(&path).expect("still there"), damaged);
}

#[test]
fn tasks_without_enough_solutions_are_named() {
    let folder = tempdir().expect("a folder");
    let out = folder.path().join("solutions.jsonl").display().to_string();
    let said =
        output_of(&["data", "collect", "--template", "24", "--limit", "3", "--max-rollouts", "1", "--out", &out]);
    assert!(said.contains("3 of 3 tasks have fewer than 10 solutions, 3 have none"), "{said}");
    assert!(said.contains("00024: 3 without a solution, the first is 00024:006"), "{said}");
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
        let few = ["data", "collect", "--template", "2", "--limit", "20", "--per-task", "2", "--out", &own];
        assert_refused(&[&few[..], more].concat(), words);
    };
    refused(&["--seed", "5"], "`seed` is 0 instead of 5): choose another file, or remove this one");
    let other = ["data", "collect", "--per-task", "2", "--out", &own];
    assert_refused(&other, "`limit` is 20 instead of 100, `template` is 2 instead of none");
}
