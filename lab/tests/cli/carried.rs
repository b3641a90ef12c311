//! `pathlight-lab measure evaluate --carry`, and the page of its results.

use std::fs;

use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

#[test]
fn agents_that_remember_meet_all_tasks_in_every_order() {
    let folder = tempdir().expect("a folder");
    let file = folder.path().join("cross-0.json").display().to_string();
    let measure = ["measure", "evaluate", "--carry", "--setup", "cross", "--limit", "2"];
    let printed = output_of(&[&measure[..], &["--shuffle", "5", "--json", &file]].concat());
    let report: Value = serde_json::from_slice(&fs::read(&file).expect("results")).expect("JSON");
    let runs = report["runs"].as_array().expect("runs");
    // Five uses of the memory by the model's agent, one by the same with paths, two by the paper's and by the random
    // one; those with the whole memory in two orders.
    assert_eq!(runs.len(), 10 + 4);
    let tasks = |run: &Value| -> Vec<String> {
        let solved = run["first_solved"].as_array().expect("tasks");
        solved.iter().map(|task| task[0].as_str().expect("an id").to_string()).collect()
    };
    let ids = tasks(&runs[0]);
    assert!(ids.len() == 10 && ids.is_sorted(), "{ids:?}");
    let shuffled = tasks(runs.iter().find(|run| run.get("shuffle").is_some()).expect("a shuffled run"));
    assert_ne!(shuffled, ids);
    for run in runs {
        assert_eq!(tasks(run), if run.get("shuffle").is_some() { shuffled.clone() } else { ids.clone() });
    }
    assert!(printed.contains("cross, fold 0, 10 test tasks"), "{printed}");
    assert_refused(&["measure", "carried", &folder.path().display().to_string()], "holds only some of the tasks");
}

#[test]
fn the_papers_nets_are_left_out_where_they_have_learned_from_the_tasks() {
    let printed = output_of(&["measure", "evaluate", "--carry", "--setup", "cross", "--dev", "--limit", "1"]);
    assert!(printed.contains("| random |") && !printed.contains("| the paper's four nets |"), "{printed}");
}

#[test]
fn results_of_agents_that_remember_are_refused_where_they_would_mislead() {
    let dev = ["measure", "evaluate", "--carry", "--setup", "within", "--dev"];
    assert_refused(&dev, "were trained on the dev tasks too");
    assert_refused(&["measure", "evaluate", "--shuffle", "1"], "--carry");
    assert_refused(&["measure", "carried", "no/such/folder"], "there are no results in no/such/folder");
}

#[test]
fn the_page_says_what_the_results_beside_it_say() {
    let printed = output_of(&["measure", "carried", "results/carried"]);
    let remedy = "run `pathlight-lab measure carried results/carried >results/carried/README.md`";
    assert_eq!(fs::read_to_string(root("results/carried/README.md")).expect("a page"), printed, "{remedy}");
}
