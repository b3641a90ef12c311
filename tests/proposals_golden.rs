//! The shipped models propose the same balls as before, natively and in wasm, on a hundred tasks.
//!
//! There is one digest for each template, over the proposals for four of its tasks: two by each shipped model, ranked
//! by its dynamics net and taken from its placement map. The same file runs under `cargo test` and
//! `wasm-pack test --node`, against the same digests, because the layers of the nets round alike on both. When
//! proposals are meant to change, raise `agents::VERSION` and run
//! `UPDATE_GOLDEN=1 cargo test --release --test proposals_golden`; when other weights are published, only run this
//! command.

use md5::{Digest, Md5};
use pathlight::agents::{self, Origin};
use pathlight::nets::PathNet;
use pathlight::puzzle::task::{Task, ids};
use pathlight::puzzle::templates::{TEMPLATES, Template};

const GOLDEN: &str = include_str!("golden/proposals.txt");

const WEIGHTS: [&[u8]; 2] =
    [include_bytes!("../assets/within-0.safetensors"), include_bytes!("../assets/cross-0.safetensors")];

/// Number of proposals for each task: those ranked by the dynamics net, and those from the placement map.
const IMAGINED: usize = 100;
const FROM_MAP: usize = 20;

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn every_proposal_is_as_it_was() {
    let models = WEIGHTS.map(|bytes| PathNet::load(bytes).expect("our own weights").0);
    let lines = TEMPLATES.iter().map(|template| format!("{:05} {}\n", template.number, digest(template, &models)));
    let digests = format!("agents version {}\n{}", agents::VERSION, lines.collect::<String>());
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/proposals.txt");
        std::fs::write(path, &digests).unwrap_or_else(|error| panic!("{path}: {error}"));
        return;
    }
    let pairs = digests.lines().zip(GOLDEN.lines().chain(std::iter::repeat("")));
    let changed: Vec<&str> = pairs.filter(|(now, then)| now != then).map(|(now, _)| now).collect();
    assert!(changed.is_empty() && digests.len() == GOLDEN.len(), "not as in tests/golden/proposals.txt: {changed:?}");
}

/// Returns the MD5 of the balls and their origins; all bits of the probabilities count.
fn digest(template: &'static Template, models: &[PathNet; 2]) -> String {
    let mut md5 = Md5::new();
    for (index, id) in ids(template).step_by(25).enumerate() {
        let scene = Task::load(id).expect("an id of the template").scene;
        let nets = &models[index % 2];
        let imagined = agents::propose(nets, &scene, id.seed(0), IMAGINED);
        assert_eq!(imagined.len(), IMAGINED, "{id}");
        let from_map = agents::from_map(nets, &scene, id.seed(0), FROM_MAP);
        assert_eq!(from_map.len(), FROM_MAP, "{id}");
        for proposal in imagined.into_iter().chain(from_map) {
            let origin = match proposal.origin {
                Origin::Imagined { prior, probability, lowered_by } => {
                    format!("imagined {:016x} {:016x} {lowered_by:?}", prior.to_bits(), probability.to_bits())
                }
                origin => format!("{origin:?}"),
            };
            md5.update(format!("{id} {} {origin}\n", proposal.ball));
        }
    }
    md5.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
