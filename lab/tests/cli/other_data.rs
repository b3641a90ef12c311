//! `pathlight-lab measure random-scenes` and `proposed-balls`: the results of nets that learned from other data than
//! those of the main results, beside these.

use std::fs;

use pathlight::benchmark::folds::{Fold, Setup};
use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

#[test]
fn results_stand_beside_the_main_ones_of_the_same_folds() {
    let folder = tempdir().expect("a folder");
    let name = folder.path().display().to_string();
    let words = ["measure", "proposed-balls", &name];
    let put = |result: &Value| fs::write(folder.path().join("within-0.json"), result.to_string()).expect("written");
    assert_refused(&words, "there are no results in");

    let mut result = json("results/shipped/within-0.json");
    put(&result);
    assert_refused(&words, "does not hold the agents online, online-by-balls, dynamics");
    let online = add_online_by_balls(&mut result);
    result["card"]["dynamics"]["variants"] = 7.into();
    put(&result);
    let page = output_of(&words);
    assert!(page.contains("7 variants"), "{page}");
    let main = json("results/within-0.json");
    let of_main = main["report"]["agents"].as_array().expect("agents").iter().find(|agent| agent["agent"] == "online");
    let [with, without] =
        [&online, of_main.expect("the online agent")].map(|score| score["auccess"].as_f64().expect("a number"));
    let cells = format!("| within | 1 | **online** | {with:.1} | {without:.1} | {:.1}, ", with - without);
    assert!(page.contains(&cells), "{page} lacks {cells}");

    result["tasks_of"] = "dev".into();
    put(&result);
    assert_refused(&words, "on all test tasks of within-0");
}

#[test]
fn results_on_all_tasks_stand_beside_the_main_ones_of_every_fold() {
    let folder = tempdir().expect("a folder");
    let name = folder.path().display().to_string();
    let words = ["measure", "random-scenes", &name];
    let put = |result: &Value| fs::write(folder.path().join("all-tasks.json"), result.to_string()).expect("written");
    assert_refused(&words, "write it with `scripts/random-scenes-table`");

    // The online agent solves the tasks of fold 3 at the first attempt and no others.
    let mut result = json("results/random-scenes/all-tasks.json");
    let tests = Fold::new(Setup::Cross, 3).test;
    let agents = result["agents"].as_array_mut().expect("agents");
    let online = agents.iter_mut().find(|agent| agent["agent"] == "online").expect("the online agent");
    for first in online["first_solved"].as_array_mut().expect("a list") {
        let task = first[0].as_str().expect("an id").parse().expect("an id");
        first[1] = if tests.contains(&task) { 1.into() } else { Value::Null };
    }
    put(&result);
    let page = output_of(&words);
    assert!(page.contains("| cross | 3 | **100.0** 100 / 100 / 100 % |"), "{page}");
    assert!(page.contains("\n| **20.0** 20 / 20 / 20 % |"), "500 of 2,500 tasks: {page}");

    result["tasks_of"] = "test".into();
    put(&result);
    assert_refused(&words, "of this version, on all tasks: remove it");
}

#[test]
fn results_of_the_other_setup_are_refused() {
    let folder = tempdir().expect("a folder");
    let mut result = json("results/shipped/cross-0.json");
    add_online_by_balls(&mut result);
    fs::write(folder.path().join("cross-0.json"), result.to_string()).expect("written");
    let name = folder.path().display().to_string();
    assert_refused(&["measure", "proposed-balls", &name], "holds results of a setup other than within");
}

/// Adds the agent online-by-balls, with the results of the online agent; returns these.
fn add_online_by_balls(result: &mut Value) -> Value {
    let agents = result["agents"].as_array_mut().expect("agents");
    let online = agents.iter().find(|agent| agent["agent"] == "online").expect("the online agent").clone();
    let mut by_balls = online.clone();
    by_balls["agent"] = "online-by-balls".into();
    agents.push(by_balls);
    online
}

/// Reads a file of the project.
fn json(path: &str) -> Value {
    serde_json::from_slice(&fs::read(root(path)).expect("a result")).expect("JSON")
}

#[test]
fn each_page_says_what_the_results_beside_it_say() {
    for table in ["proposed-balls", "random-scenes"] {
        let folder = format!("results/{table}");
        let printed = output_of(&["measure", table, &folder]);
        let page = fs::read_to_string(root(&folder).join("README.md")).expect("a page");
        assert_eq!(page, printed, "run `scripts/{table}-table`");
    }
}
