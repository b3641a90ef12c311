//! The ten folds of both setups are PHYRE's.
//!
//! PATHLIGHT_PHYRE names the folder with PHYRE's `folds.json`, and `--include-ignored` runs the comparison with it. The
//! digest needs no data: it was taken when that comparison succeeded.
#![cfg(not(target_arch = "wasm32"))]

use std::path::Path;

use md5::{Digest, Md5};
use pathlight::benchmark::folds::{FOLDS, Fold, Setup};
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::{TASKS, TEMPLATES};
use serde_json::Value;

/// MD5 of the 20 folds, each task on a line with its fold and part.
const DIGEST: &str = "0747641dd21e7b49d2eb665a1dc1ffb4";

#[test]
fn every_fold_is_as_it_was() {
    let mut md5 = Md5::new();
    for setup in [Setup::Within, Setup::Cross] {
        for number in 0..FOLDS {
            let fold = Fold::new(setup, number);
            for (part, tasks) in [("train", &fold.train), ("dev", &fold.dev), ("test", &fold.test)] {
                for task in tasks {
                    md5.update(format!("{setup} {number} {part} {task}\n"));
                }
            }
        }
    }
    let digest: String = md5.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(digest, DIGEST, "run this test with PATHLIGHT_PHYRE set and --include-ignored to see what differs");
}

#[test]
#[ignore = "needs PATHLIGHT_PHYRE"]
fn every_fold_is_the_benchmarks() {
    let folder = std::env::var("PATHLIGHT_PHYRE").expect("PATHLIGHT_PHYRE names the folder with PHYRE's folds.json");
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
            assert_eq!(trained.len() + fold.test.len(), TEMPLATES.len() * TASKS);
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
