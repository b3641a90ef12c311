//! `pathlight calibration` and `publish-results`: what the page shows of the shipped models.

use std::fs;

use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, without_dynamics};

fn json(path: &std::path::Path) -> Value {
    serde_json::from_slice(&fs::read(path).expect("a file")).expect("JSON")
}

#[test]
fn likely_balls_solve_more_often_and_the_file_holds_what_the_table_says() {
    let folder = tempdir().expect("a folder");
    let file = folder.path().join("bins.json");
    let table = output_of(&["calibration", "--limit", "1", "--balls", "4", "--json", &file.display().to_string()]);
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

#[test]
fn the_file_of_the_page_is_that_of_the_measurements() {
    let folder = tempdir().expect("a folder");
    fs::copy("assets/model.json", folder.path().join("model.json")).expect("a copy");
    output_of(&["publish-results", "--assets", &folder.path().display().to_string()]);
    let made = fs::read(folder.path().join("results.json")).expect("a file");
    assert!(made == fs::read("assets/results.json").expect("shipped"), "run `pathlight publish-results` again");
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
    assert_refused(&["calibration", "--weights", &without_dynamics(folder.path())], "have no dynamics net");
    assert_refused(
        &["publish-results", "--results", &path],
        "within-0.json: write it with `pathlight evaluate --json`",
    );
    assert_refused(&["publish-results", "--assets", &path], "write it with `pathlight publish`");
    fs::copy("assets/model.json", folder.path().join("model.json")).expect("a copy");
    for model in ["within-0", "cross-0"] {
        for file in [format!("{model}.json"), format!("{model}-calibration.json")] {
            fs::copy(format!("results/shipped/{file}"), folder.path().join(file)).expect("a copy");
        }
    }
    let older = folder.path().join("within-0-calibration.json");
    let mut calibration = json(&older);
    calibration["agents_version"] = 2.into();
    fs::write(&older, calibration.to_string()).expect("a file");
    assert_refused(
        &["publish-results", "--results", &path, "--assets", &path],
        "does not belong to the evaluation beside it",
    );
}
