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
fn results_of_different_settings_are_refused_in_one_table() {
    let folder = tempdir().expect("a folder");
    let name = folder.path().display().to_string();
    assert_refused(&["measure", "paper", &name], "there are no results in");
    let result = fs::read_to_string(root("results/paper/within-0.json")).expect("a result");
    fs::write(folder.path().join("within-0.json"), &result).expect("written");
    let one = output_of(&["measure", "paper", &name]);
    let mut other: Value = serde_json::from_str(&result).expect("JSON");
    other["fold"] = 1.into();
    fs::write(folder.path().join("within-1.json"), other.to_string()).expect("written");
    let two = output_of(&["measure", "paper", &name]);
    let mean = |page: &str| page.lines().find(|line| line.starts_with("| within | ours |")).map(str::to_string);
    assert!(mean(&one).is_some() && mean(&one) == mean(&two), "the mean of two equal folds: {two}");
    other["card"]["epochs"] = 11.into();
    fs::write(folder.path().join("within-1.json"), other.to_string()).expect("written");
    assert_refused(&["measure", "paper", &name], "within-1.json was made with other settings than within-0.json");
}
