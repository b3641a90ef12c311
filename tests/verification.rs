//! The shipped attempts, which every page verifies too: the same rollouts to the bit, natively and in wasm.
//!
//! `assets/attempts.jsonl` is written by `pathlight simulate --batch - --verifiable`.

use std::collections::BTreeSet;

use pathlight::verification::{AttemptLine, Verdict};

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn the_shipped_attempts_are_the_same_to_the_bit() {
    let lines = include_str!("../assets/attempts.jsonl").lines();
    let attempts: Vec<AttemptLine> = lines.map(|line| serde_json::from_str(line).expect("an attempt")).collect();
    let templates: BTreeSet<usize> = attempts.iter().filter_map(|attempt| Some(attempt.task?.template)).collect();
    assert!(templates.into_iter().eq(0..25), "some of every template");
    for attempt in attempts {
        assert_eq!(attempt.verify(), Verdict::Same, "{attempt:?}");
    }
}
