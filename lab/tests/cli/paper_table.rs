//! `pathlight-lab measure paper`, and the page of its results.

use std::fs;

use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

#[test]
fn the_page_says_what_the_results_beside_it_say() {
    let printed = output_of(&["measure", "paper", "results/paper"]);
    let remedy = "run `pathlight-lab measure paper results/paper >results/paper/README.md`";
    assert_eq!(fs::read_to_string(root("results/paper/README.md")).expect("a page"), printed, "{remedy}");
}

#[test]
fn a_table_needs_results_that_are_whole_and_made_alike() {
    let folder = tempdir().expect("a folder");
    let name = folder.path().display().to_string();
    let put = |name: &str, result: &str| fs::write(folder.path().join(name), result).expect("written");
    let [zero, one] = ["within-0.json", "within-1.json"]
        .map(|name| fs::read_to_string(root(&format!("results/paper/{name}"))).expect("a result"));
    assert_refused(&["measure", "paper", &name], "there are no results in");

    put("within-0.json", &zero);
    let page = output_of(&["measure", "paper", &name]);
    let report: Value = serde_json::from_str(&zero).expect("JSON");
    let agents = report["agents"].as_array().expect("agents");
    let paper = agents.iter().find(|agent| agent["agent"] == "paper").expect("the paper's agent");
    // Each template has as many test tasks, so that both means are alike.
    let auccess = paper["auccess"].as_f64().expect("a number");
    assert!(page.contains(&format!("| within | ours | {auccess:.1} | {auccess:.1} |")), "{page}");
    assert!(page.contains("1 of 20 folds"), "{page}");

    put("within-1.json", &zero);
    assert_refused(&["measure", "paper", &name], "on all test tasks of within-1");
    let mut other: Value = serde_json::from_str(&one).expect("JSON");
    other["tasks_of"] = "dev".into();
    put("within-1.json", &other.to_string());
    assert_refused(&["measure", "paper", &name], "on all test tasks of within-1");
    other["tasks_of"] = "test".into();
    other["card"]["epochs"] = 11.into();
    put("within-1.json", &other.to_string());
    assert_refused(&["measure", "paper", &name], "within-1.json was made with other settings than within-0.json");
    put("within-1.json", &one);
    assert!(output_of(&["measure", "paper", &name]).contains("2 of 20 folds"));
}
