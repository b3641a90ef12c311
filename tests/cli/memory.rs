//! `pathlight agent` with puzzles that it remembers, and the files that keep its memory.

use std::fs;
use std::path::Path;

use pathlight::agents::memory::CAPACITY;
use serde_json::{Value, json};
use tempfile::tempdir;

use crate::agent::Partner;
use crate::{assert_refused, run, stderr, stdout};

const RANDOM: [&str; 3] = ["agent", "--agent", "random"];

/// Returns the random agent's answers to some lines.
fn answers(more: &[&str], lines: &[Value]) -> Vec<Value> {
    let text: Vec<String> = lines.iter().map(Value::to_string).collect();
    let output = run(&[&RANDOM, more].concat(), &text.join("\n"));
    let answers: Vec<Value> =
        stdout(&output).lines().map(|line| serde_json::from_str(line).expect("an answer")).collect();
    assert_eq!(answers.len(), lines.len(), "{}", stderr(&output));
    answers
}

/// Returns the lines of a puzzle that is solved at the third attempt.
fn puzzle(task: &str, remember: bool) -> Vec<Value> {
    let [failed, solved] = ["not_solved", "solved"].map(|status| json!({ "status": status }));
    vec![json!({ "task": task, "remember": remember }), failed.clone(), failed, solved]
}

#[test]
fn what_a_puzzle_taught_is_used_at_the_next_until_it_is_forgotten() {
    let [first, second] = ["00002:007", "00002:017"];
    let next = |remember: bool| json!({ "task": second, "remember": remember });
    let lines = [puzzle(first, true), vec![next(true), next(false), json!({ "forget": true }), next(true)]].concat();
    let answers = answers(&[], &lines);
    assert!(answers[..3].iter().all(|answer| answer.get("reminder").is_none()), "{answers:?}");
    let solution = &answers[2]["ball"];
    let reminder = &answers[4]["reminder"];
    assert_eq!((&reminder["puzzle"], &reminder["task"]), (&json!(1), &json!(first)));
    let numbers = |ball: &Value| -> Vec<f64> { serde_json::from_value(ball.clone()).expect("three numbers") };
    assert_eq!(numbers(&reminder["ball"]), numbers(solution), "{reminder}");
    assert_eq!(reminder["solved"], true, "{reminder}");
    assert!(reminder["change"].as_f64().is_some_and(|change| change > 0.0), "{reminder}");
    assert!(answers[5].get("reminder").is_none(), "it was not asked to remember");
    assert_eq!(answers[6], json!({ "line": 7, "remembered": 0 }));
    assert!(answers[7].get("reminder").is_none(), "it has forgotten");
    assert_ne!(answers[4]["ball"], answers[7]["ball"]);
}

#[test]
fn what_is_forgotten_in_the_middle_of_a_puzzle_is_no_reminder_any_more() {
    let [first, second] = ["00002:007", "00002:017"];
    let begun = [json!({ "task": second, "remember": true }), json!({ "status": "not_solved" })];
    let lines = |between: &[Value]| [&puzzle(first, true)[..], &begun[..1], between, &begun[1..]].concat();
    let last = |between: &[Value]| answers(&[], &lines(between)).pop().expect("an answer");
    assert_eq!(last(&[])["reminder"]["task"], first);
    assert!(last(&[json!({ "forget": true })]).get("reminder").is_none());
}

#[test]
fn a_memory_in_a_file_goes_on_where_it_ended() {
    let folder = tempdir().expect("a folder");
    let file = folder.path().join("memory.json").display().to_string();
    let [before, after] = [["00002:007", "00002:017"], ["00002:023", "00007:008"]]
        .map(|tasks| tasks.map(|task| puzzle(task, true)).concat());
    let balls = |answers: &[Value]| answers.iter().map(|answer| answer["ball"].clone()).collect::<Vec<_>>();
    let whole = balls(&answers(&[], &[before.clone(), after.clone()].concat()));
    let memory = ["--memory", &file];
    let parts = [answers(&memory, &before), answers(&memory, &after)].concat();
    assert_eq!(balls(&parts), whole);
    let kept: Value = serde_json::from_slice(&fs::read(&file).expect("a memory")).expect("JSON");
    assert_eq!(kept["puzzles"].as_array().map(Vec::len), Some(4));
    assert_refused(&["agent", "--memory", &file], "learned by an agent without weights");
    for (content, words) in [("{", "damaged"), (r#"{"version":9}"#, "format 9")] {
        fs::write(&file, content).expect("a file");
        assert_refused(&[&RANDOM[..], &memory].concat(), words);
        assert_eq!(fs::read_to_string(&file).expect("a file"), content, "it is left as it was");
        let beside = fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(beside, 2, "and nothing but the lock is left beside it");
    }
    assert_refused(&["agent", "--weights", &file], "not a safetensors file");
}

#[test]
fn a_program_that_is_killed_has_kept_the_puzzles_that_were_over() {
    let folder = tempdir().expect("a folder");
    let file = folder.path().join("memory.json").display().to_string();
    let mut agent = Partner::new(&[&RANDOM[..], &["--memory", &file]].concat());
    let begun = &puzzle("00002:017", true)[..2];
    for line in puzzle("00002:007", true).iter().chain(begun) {
        agent.ask(&line.to_string());
    }
    assert_refused(&[&RANDOM[..], &["--memory", &file]].concat(), "another process is using the memory");
    agent.kill();
    let kept: Value = serde_json::from_slice(&fs::read(&file).expect("a memory")).expect("JSON");
    assert_eq!(kept["puzzles"][0]["task"], "00002:007");
    assert_eq!(kept["puzzles"].as_array().map(Vec::len), Some(1), "the other was not over");
}

#[test]
fn attempts_at_puzzles_that_were_left_are_kept_and_so_are_those_after_forgetting() {
    let folder = tempdir().expect("a folder");
    let file = folder.path().join("memory.json").display().to_string();
    let kept = || -> Vec<Value> {
        let kept: Value = serde_json::from_slice(&fs::read(&file).expect("a memory")).expect("JSON");
        kept["puzzles"].as_array().expect("puzzles").iter().map(|puzzle| puzzle["task"].clone()).collect()
    };
    let mut agent = Partner::new(&[&RANDOM[..], &["--memory", &file]].concat());
    for line in [&puzzle("00002:007", true)[..3], &puzzle("00002:017", true)[..1]].concat() {
        agent.ask(&line.to_string());
    }
    agent.kill();
    assert_eq!(kept(), ["00002:007"], "it was left for the next");

    // A full memory forgets as many attempts as it learns.
    let attempts = vec![json!({ "ball": [30, 230, 8], "chance": 0.25, "solved": false }); CAPACITY];
    let full = json!({ "version": 1, "forgotten": 0, "puzzles": [{ "task": "00002:007", "attempts": attempts }] });
    fs::write(&file, full.to_string()).expect("a file");
    let mut agent = Partner::new(&[&RANDOM[..], &["--memory", &file]].concat());
    let left = puzzle("00002:023", true).into_iter().take(2).chain(puzzle("00002:017", true).into_iter().take(1));
    for line in left {
        agent.ask(&line.to_string());
    }
    agent.kill();
    assert_eq!(kept(), ["00002:023"], "it took the place of the other");
    fs::remove_file(&file).expect("removed");

    let begun = &puzzle("00002:023", true)[..2];
    let lines = [begun, &[json!({ "forget": true })], &puzzle("00002:023", true)[1..]].concat();
    answers(&["--memory", &file], &lines);
    assert_eq!(kept(), ["00002:023"], "what was tried after forgetting is remembered");

    // A file is no folder.
    let nowhere = format!("{file}/memory.json");
    assert_refused(&[&RANDOM[..], &["--memory", &nowhere]].concat(), "cannot write");
}

#[cfg(unix)]
#[test]
fn a_memory_is_kept_and_locked_where_links_lead() {
    let folder = tempdir().expect("a folder");
    let [file, link, other] = ["kept/memory.json", "link", "other"].map(|name| folder.path().join(name));
    std::os::unix::fs::symlink(&file, &link).expect("a link");
    std::os::unix::fs::symlink("link", &other).expect("a link");
    let [file, link, other] = [file, link, other].map(|path| path.display().to_string());
    let mut agent = Partner::new(&[&RANDOM[..], &["--memory", &link]].concat());
    agent.ask(&puzzle("00002:007", true)[0].to_string());
    for name in [&file, &link, &other] {
        assert_refused(&[&RANDOM[..], &["--memory", name]].concat(), "another process is using the memory");
    }
    agent.kill();
    answers(&["--memory", &other], &puzzle("00002:007", true));
    assert!(Path::new(&link).is_symlink() && Path::new(&other).is_symlink());
    assert!(fs::read_to_string(&file).expect("a memory").contains("00002:007"));
}

#[test]
fn remember_and_forget_are_refused_where_they_mean_nothing() {
    let lines = [
        json!({ "status": "solved", "remember": true }),
        json!({ "task": "00002:007", "forget": true }),
        json!({ "remember": true }),
    ];
    let words = ["belongs on the line that begins", "on a separate line", "are missing"];
    for (answer, words) in answers(&[], &lines).iter().zip(words) {
        assert!(answer["error"].as_str().is_some_and(|said| said.contains(words)), "{answer}");
    }
    let dynamics =
        run(&["agent", "--agent", "dynamics"], &lines[2].to_string().replace('{', r#"{"task":"00002:007","#));
    assert!(stdout(&dynamics).contains("cannot remember"), "{}", stdout(&dynamics));
    let folder = tempdir().expect("a folder");
    let file = folder.path().join("memory.json").display().to_string();
    assert_refused(&["agent", "--agent", "dynamics", "--memory", &file], "cannot remember");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0, "no file is made for it");
}
