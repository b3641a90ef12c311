//! `pathlight table`: rows by the job array's script, and the report on them.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of};

/// What all of the table's processes are told here: little data, little training, few tasks.
fn small(folder: &Path) -> Vec<String> {
    let within = |name: &str| folder.join(name).display().to_string();
    let words = [
        "--results",
        &within("results"),
        "--runs",
        &within("runs"),
        "--solutions",
        &within("solutions.jsonl"),
        "--labels",
        &within("labels.jsonl"),
        "--epochs",
        "1",
        "--judge-epochs",
        "2",
        "--judge-epochs-cross",
        "1",
        "--limit",
        "1",
    ];
    words.map(String::from).to_vec()
}

/// A job of the array.
fn job(row: &str, words: &[String]) -> Output {
    let mut script = Command::new("results/array.sh");
    script.env("PATHLIGHT", env!("CARGO_BIN_EXE_pathlight")).env("SLURM_ARRAY_TASK_ID", row).args(words);
    script.output().expect("the script runs")
}

#[test]
fn jobs_make_rows_and_the_report_reads_them() {
    let folder = tempdir().expect("a folder");
    let words = small(folder.path());
    let (solutions, labels) = (words[5].as_str(), words[7].as_str());
    output_of(&["collect", "--template", "2", "--limit", "10", "--rounds", "2", "--wanted", "3", "--out", solutions]);
    let few = ["--template", "2", "--limit", "6", "--rounds", "1", "--solutions", solutions];
    output_of(&[&["label", "--out", labels], &few[..]].concat());

    for row in ["3", "10"] {
        let made = job(row, &words);
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    }
    let results = folder.path().join("results");
    let file = |name: &str| fs::read(results.join(name)).expect("a row");
    let row: Value = serde_json::from_slice(&file("within-3.json")).expect("JSON");
    assert_eq!(row["report"]["card"]["judge"]["epochs"], 2);
    assert_eq!(row["nets"]["losses"].as_array().map(Vec::len), Some(4));
    assert_eq!(row["judge"]["by_epoch"].as_array().map(Vec::len), Some(2));
    let agents: Vec<&Value> = row["report"]["agents"].as_array().expect("agents").iter().collect();
    assert_eq!(agents.iter().map(|one| &one["agent"]).collect::<Vec<_>>(), ["judge", "paper", "random"]);
    assert!(agents.iter().all(|one| one["first_solved"].as_array().is_some_and(|tasks| tasks.len() == 25)));

    let before = file("cross-0.json");
    let again = job("10", &words);
    assert!(String::from_utf8_lossy(&again.stderr).contains("cross-0.json is there"));
    assert_eq!(file("cross-0.json"), before);
    let other: Vec<String> = [&words[..], &["--seed".to_string(), "1".to_string()]].concat();
    let refused = job("10", &other);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("name another folder with --results"));

    let report = ["table", "--only", "report"].into_iter().chain(words.iter().map(String::as_str));
    let printed = output_of(&report.collect::<Vec<_>>());
    assert_eq!(printed, fs::read_to_string(results.join("README.md")).expect("a report"));
    let random = row["report"]["agents"][2]["auccess"].as_f64().expect("a number");
    assert!(printed.lines().any(|line| line.starts_with("| **random** |") && line.contains(&format!(" {random:.1} "))));
    let picture = fs::read_to_string(results.join("templates.svg")).expect("a picture");
    assert!(picture.contains("within, mean of 1 fold") && picture.contains("00024"));
}

#[test]
fn a_table_says_what_it_lacks() {
    let folder = tempdir().expect("a folder");
    let words = small(folder.path());
    let with = |part: &'static str| {
        ["table", "--only", part].into_iter().chain(words.iter().map(String::as_str)).collect::<Vec<_>>()
    };
    assert_refused(&with("report"), "holds no rows");
    assert_refused(&with("rows"), "run `pathlight collect` first");
    fs::create_dir(folder.path().join("results")).expect("a folder");
    fs::write(folder.path().join("results/within-0.json"), "{").expect("a file");
    assert_refused(&with("rows"), "is no row of `pathlight table`");
    let unnamed = Command::new("results/array.sh").env_remove("SLURM_ARRAY_TASK_ID").output().expect("it runs");
    assert!(String::from_utf8_lossy(&unnamed.stderr).contains("is not set: give the row, 0 to 19"));
}
