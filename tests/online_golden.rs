//! The online agent tries the same balls in the same order, with the same probabilities bit for bit, natively and in
//! wasm.
//!
//! The candidates are made up, and the attempts all fail in made-up ways. When the order is meant to change, raise
//! `agents::VERSION` and replace the digest by the one that the test prints.

use md5::{Digest, Md5};
use pathlight::agents::online::{Candidate, OnlineAgent, Similarity};
use pathlight::agents::{Agent, Observation, Origin};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::sampled_paths::{SAMPLES, SampledPath, SampledPaths};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const CANDIDATES: usize = 400;

const GOLDEN: &str = "a9bed54df7c7c69e9d45528d70168ee3";

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn a_turn_of_a_hundred_failures_is_as_it_was() {
    let mut rng = Pcg64Mcg::seed_from_u64(7);
    let candidates: Vec<Candidate> = (0..CANDIDATES)
        .map(|_| Candidate {
            ball: Ball { x: px(&mut rng), y: px(&mut rng), r: 2.0 + (px(&mut rng) / 9.0).floor() },
            logit: px(&mut rng) / 40.0 - 4.0,
            paths: paths(&mut rng),
        })
        .collect();
    let mut agent = OnlineAgent::new(candidates, Similarity::DEFAULT);
    let mut md5 = Md5::new();
    for _ in 0..MAX_ATTEMPTS {
        let proposal = agent.propose().expect("a candidate is left");
        let Origin::Imagined { prior, probability, lowered_by } = proposal.origin else { panic!("{proposal:?}") };
        let [prior, probability] = [prior, probability].map(f64::to_bits);
        md5.update(format!("{} {prior:016x} {probability:016x} {lowered_by:?}\n", proposal.ball));
        agent.observe(&Observation { solved: false, paths: Some(paths(&mut rng)) });
    }
    let digest: String = md5.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(digest, GOLDEN);
}

/// Returns a whole number of px inside the scene.
fn px(rng: &mut Pcg64Mcg) -> f64 {
    f64::from(rng.random_range(32..224))
}

/// Returns paths in a straight line to one of a few places.
fn paths(rng: &mut Pcg64Mcg) -> SampledPaths {
    let path = |end: [f32; 2]| -> SampledPath {
        std::array::from_fn(|sample| end.map(|at| 128.0 + (at - 128.0) * sample as f32 / SAMPLES as f32))
    };
    let mut end = || [0, 1].map(|_| 16.0 * f32::from(rng.random_range(2..14_u8)));
    SampledPaths { object: path(end()), ball: path(end()) }
}
