//! `pathlight-lab measure calibration` and `publish results`: the measurements of the shipped models on the page.

use std::fs;
use std::path::Path;

use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, changed_weights, output_of, root, without_dynamics};

fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).expect("a file")).expect("JSON")
}

#[test]
fn likely_balls_solve_more_often_and_the_file_holds_what_the_table_says() {
    let folder = tempdir().expect("a folder");
    let file = folder.path().join("bins.json");
    let table =
        output_of(&["measure", "calibration", "--limit", "1", "--balls", "4", "--json", &file.display().to_string()]);
    assert_eq!(table.lines().count(), 2 + 10, "{table}");
    let bins = json(&file);
    for kind in ["random", "candidates"] {
        let of = |key: &str| -> Vec<u64> {
            bins[kind].as_array().expect("bins").iter().map(|bin| bin[key].as_u64().expect("a count")).collect()
        };
        let (balls, solved) = (of("balls"), of("solved"));
        assert_eq!(balls.iter().sum::<u64>(), 25 * 4, "{kind}");
        assert!(solved.iter().zip(&balls).all(|(solved, balls)| solved <= balls), "{kind}");
        let share = |bins: std::ops::Range<usize>| {
            solved[bins.clone()].iter().sum::<u64>() as f64 / balls[bins].iter().sum::<u64>().max(1) as f64
        };
        assert!(kind == "random" || share(5..10) > share(0..5), "{table}");
    }
}

/// Copies the list of models and their weights.
fn copy_assets(folder: &Path) {
    for file in ["model.json", "within-0.safetensors", "cross-0.safetensors"] {
        fs::copy(root("assets").join(file), folder.join(file)).expect("a copy");
    }
}

#[test]
fn the_file_of_the_page_is_that_of_the_measurements() {
    let folder = tempdir().expect("a folder");
    copy_assets(folder.path());
    output_of(&["publish", "results", "--assets", &folder.path().display().to_string()]);
    let made = fs::read(folder.path().join("results.json")).expect("a file");
    assert!(
        made == fs::read(root("assets/results.json")).expect("shipped"),
        "run `pathlight-lab publish results` again"
    );
    let (results, models) = (json(&folder.path().join("results.json")), json(&folder.path().join("model.json")));
    let models = models["models"].as_array().expect("a list");
    assert_eq!(results["models"].as_array().expect("a list").len(), models.len());
    for (result, model) in results["models"].as_array().expect("a list").iter().zip(models) {
        assert_eq!(result["name"], model["name"]);
        assert_eq!(result["tasks"].as_array().map(Vec::len), Some(500));
        for firsts in result["first_solved"].as_object().expect("agents").values() {
            assert_eq!(firsts.as_array().map(Vec::len), Some(500));
        }
    }
}

#[test]
fn what_cannot_be_measured_or_found_is_refused() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().display().to_string();
    assert_refused(&["measure", "calibration", "--weights", &without_dynamics(folder.path())], "have no dynamics net");
    assert_refused(
        &["publish", "results", "--results", &path],
        "within-0.json: write it with `pathlight-lab measure evaluate --setup within --fold 0 --weights \
         assets/within-0.safetensors --json ",
    );
    assert_refused(&["publish", "results", "--assets", &path], "write it with `pathlight-lab publish weights`");
    copy_assets(folder.path());
    for model in ["within-0", "cross-0"] {
        for file in [format!("{model}.json"), format!("{model}-calibration.json")] {
            fs::copy(root("results/shipped").join(&file), folder.path().join(file)).expect("a copy");
        }
    }
    let publish = ["publish", "results", "--results", &path, "--assets", &path];
    let refused = |file: &str, change: fn(&mut Value), words: &str| {
        let file = folder.path().join(file);
        let kept = fs::read(&file).expect("a file");
        let mut measured = json(&file);
        change(&mut measured);
        fs::write(&file, measured.to_string()).expect("a file");
        assert_refused(&publish, words);
        fs::write(&file, kept).expect("a file");
    };
    let calibration = "within-0-calibration.json does not cover all test tasks of its fold, or is of another version";
    refused("within-0-calibration.json", |one| one["agents_version"] = 2.into(), calibration);
    refused("within-0-calibration.json", |one| one["tasks"] = 25.into(), calibration);
    refused("within-0-calibration.json", |one| one["card"]["seed"] = 9.into(), "does not belong to the weights");
    let evaluation = "cross-0.json does not cover all test tasks of its fold, or is of another version";
    refused("cross-0.json", |one| one["engine"] = "rapier".into(), evaluation);
    refused("cross-0.json", |one| one["agents"][0]["first_solved"] = Vec::<Value>::new().into(), evaluation);
    assert_refused(&["measure", "calibration", "--json", &path], "cannot write ");
    output_of(&publish);
    changed_weights(&folder.path().join("within-0.safetensors"), |_, card| card.epochs += 1);
    assert_refused(&publish, "within-0.json does not belong to the weights");
}
