//! `pathlight-lab measure random-scenes` and `proposed-balls`: the results of nets that learned from other data than
//! those of the rows, beside the rows.

use std::fs;

use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

#[test]
fn results_stand_beside_the_rows_of_the_same_folds() {
    let folder = tempdir().expect("a folder");
    let name = folder.path().display().to_string();
    let words = ["measure", "random-scenes", &name];
    let put = |result: &Value| fs::write(folder.path().join("cross-0.json"), result.to_string()).expect("written");
    assert_refused(&words, "there are no results in");

    let shipped = fs::read(root("results/shipped/cross-0.json")).expect("a result");
    let mut result: Value = serde_json::from_slice(&shipped).expect("JSON");
    put(&result);
    assert_refused(&words, "does not hold the agents online, online-by-balls, dynamics");
    let agents = result["agents"].as_array_mut().expect("agents");
    let online = agents.iter().find(|agent| agent["agent"] == "online").expect("the online agent").clone();
    let mut by_balls = online.clone();
    by_balls["agent"] = "online-by-balls".into();
    agents.push(by_balls);
    result["card"]["dynamics"]["random_scenes"] = 7.into();
    put(&result);
    let page = output_of(&words);
    assert!(page.contains("7 random scenes"), "{page}");
    let row: Value = serde_json::from_slice(&fs::read(root("results/cross-0.json")).expect("a row")).expect("JSON");
    let in_row = row["report"]["agents"].as_array().expect("agents").iter().find(|agent| agent["agent"] == "online");
    let [with, without] =
        [&online, in_row.expect("the online agent")].map(|score| score["auccess"].as_f64().expect("a number"));
    let cells = format!("| cross | 1 | **online** | {with:.1} | {without:.1} | {:.1}, ", with - without);
    assert!(page.contains(&cells), "{page} lacks {cells}");
    let put_alone = |result: &Value| fs::write(folder.path().join("alone.json"), result.to_string()).expect("written");
    put_alone(&result);
    assert_refused(&words, "alone.json is not of all tasks");
    let mut alone = result.clone();
    alone["tasks_of"] = "all".into();
    put_alone(&alone);
    let page = output_of(&words);
    assert!(page.contains("## Random scenes alone") && page.contains("\n| all | **"), "{page}");
    let cells = format!("| cross | 1 | **online** | {with:.1} | {with:.1} | {without:.1} | ");
    assert!(page.contains(&cells), "the same results on the same tasks: {page} lacks {cells}");

    result["tasks_of"] = "dev".into();
    put(&result);
    assert_refused(&words, "on all test tasks of cross-0");
}

#[test]
fn results_of_the_other_setup_are_refused() {
    let folder = tempdir().expect("a folder");
    fs::copy(root("results/random-scenes/cross-0.json"), folder.path().join("cross-0.json")).expect("copied");
    let name = folder.path().display().to_string();
    assert_refused(&["measure", "proposed-balls", &name], "holds results of another setup than within");
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
