//! The ten folds are PHYRE's, in both setups: the test tasks, the templates, and how many there are of each kind.
#![cfg(not(target_arch = "wasm32"))]

use std::path::Path;

use pathlight::benchmark::folds::{FOLDS, Fold, Setup};
use pathlight::puzzle::task::TaskId;
use serde_json::Value;

#[test]
fn every_fold_is_the_benchmarks() {
    let Ok(folder) = std::env::var("PATHLIGHT_PHYRE") else {
        println!("skipped: PATHLIGHT_PHYRE does not name the reference data");
        return;
    };
    let text = std::fs::read_to_string(Path::new(&folder).join("folds.json")).expect("folds.json is there");
    let reference: Value = serde_json::from_str(&text).expect("folds.json is JSON");
    for number in 0..FOLDS {
        let (within, cross) = (Fold::new(Setup::Within, number), Fold::new(Setup::Cross, number));
        let reference = &reference[number.to_string()];
        assert_eq!(ids(&within.test), strings(&reference["within"]["test"]), "fold {number}");
        assert_eq!(templates(&cross.test), strings(&reference["cross"]["test_templates"]), "fold {number}");
        assert_eq!(templates(&cross.dev), strings(&reference["cross"]["dev_templates"]), "fold {number}");
        assert_eq!(templates(&cross.train), strings(&reference["cross"]["train_templates"]), "fold {number}");
        for (fold, setup) in [(&within, "within"), (&cross, "cross")] {
            assert_eq!(fold.train.len() as u64, reference[setup]["n_train"], "{setup} {number}");
            assert_eq!(fold.dev.len() as u64, reference[setup]["n_dev"], "{setup} {number}");
        }
    }
}

#[test]
fn no_task_is_both_trained_and_tested_on() {
    for setup in [Setup::Within, Setup::Cross] {
        for number in 0..FOLDS {
            let fold = Fold::new(setup, number);
            let trained = fold.all_train();
            assert_eq!(trained.len() + fold.test.len(), 2500);
            assert!(fold.test.iter().all(|task| !trained.contains(task)), "{setup} {number}");
        }
    }
}

fn ids(tasks: &[TaskId]) -> Vec<String> {
    tasks.iter().map(TaskId::to_string).collect()
}

fn templates(tasks: &[TaskId]) -> Vec<String> {
    let mut templates: Vec<String> = tasks.iter().map(|task| format!("{:05}", task.template)).collect();
    templates.dedup();
    templates
}

fn strings(list: &Value) -> Vec<String> {
    let mut strings: Vec<String> =
        list.as_array().expect("a list").iter().map(|s| s.as_str().expect("text").into()).collect();
    strings.sort();
    strings
}
