//! The shipped attempts, which every page also verifies, give the same rollouts to the bit, natively and in wasm.
//!
//! `assets/attempts.jsonl` holds twelve attempts for each template: for each of three tasks, one without a ball, two
//! with random balls, and one that solves. `tests/golden/rapier.jsonl` holds some of them in the second engine,
//! natively only. To change the simulation on purpose, raise the version and run
//! `UPDATE_GOLDEN=1 cargo test --release --test verification`.

use std::collections::BTreeMap;

use pathlight::puzzle::rollout::Status;
use pathlight::verification::{AttemptLine, Verdict};

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn read(lines: &str) -> Vec<AttemptLine> {
    lines.lines().map(|line| serde_json::from_str(line).expect("an attempt")).collect()
}

#[test]
fn the_shipped_attempts_are_the_same_to_the_bit() {
    let attempts = read(include_str!("../assets/attempts.jsonl"));
    let mut templates: BTreeMap<usize, Vec<&AttemptLine>> = BTreeMap::new();
    for attempt in &attempts {
        templates.entry(attempt.task.expect("a task").template).or_default().push(attempt);
    }
    assert!(templates.keys().copied().eq(0..25), "some of every template");
    for (template, attempts) in templates {
        let count = |is: &dyn Fn(&AttemptLine) -> bool| attempts.iter().filter(|attempt| is(attempt)).count();
        let (solved, alone) = (count(&|line| line.status == Status::Solved), count(&|line| line.ball.is_none()));
        assert!(attempts.len() == 12 && solved >= 3 && alone == 3, "{template}: {solved} solve, {alone} have no ball");
    }
    are_the_same("assets/attempts.jsonl", &attempts);
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn rollouts_of_rapier_are_as_they_were() {
    are_the_same("tests/golden/rapier.jsonl", &read(include_str!("golden/rapier.jsonl")));
}

fn are_the_same(file: &str, attempts: &[AttemptLine]) {
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        let again = |attempt: &AttemptLine| {
            let task = pathlight::puzzle::task::Task::load(attempt.task.expect("a task")).expect("a task");
            let line = AttemptLine::of(&task.into(), attempt.ball, attempt.engine);
            serde_json::to_string(&line).expect("plain data") + "\n"
        };
        let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
        let lines: String = attempts.iter().map(again).collect();
        std::fs::write(&path, lines).unwrap_or_else(|error| panic!("{path}: {error}"));
        return;
    }
    for attempt in attempts {
        assert_eq!(attempt.verify(), Verdict::Same, "{file}: {attempt:?}");
    }
}
