//! The shipped models are complete: assets/model.json lists every weights file with its size and hash, the nets can
//! load it, and its weights are rounded.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::Path;

use pathlight::nets::PathNet;
use serde_json::Value;
use sha2::{Digest, Sha256};

/// Maximum size of a model, bytes.
const MAX_BYTES: usize = 3_720_000;

#[test]
fn every_model_of_the_list_is_there_whole_and_up_to_date() {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    let list = fs::read(assets.join("model.json")).expect("assets/model.json is shipped");
    let list: Value = serde_json::from_slice(&list).expect("the list is JSON");
    let models = list["models"].as_array().expect("a list of models");
    assert!(!models.is_empty());
    for model in models {
        let text = |key: &str| model[key].as_str().unwrap_or_else(|| panic!("{model} has no {key}"));
        let bytes = fs::read(assets.join(text("file"))).unwrap_or_else(|error| panic!("{}: {error}", text("file")));
        let digest: String = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(digest, text("sha256"), "run `pathlight-lab publish weights` again");
        assert_eq!(model["size"], bytes.len(), "run `pathlight-lab publish weights` again");
        let (nets, card) = PathNet::load(&bytes).expect("weights that fit");
        assert_eq!(text("name"), format!("{}-{}", card.setup, card.fold));
        assert!(bytes.len() < MAX_BYTES, "{} is {} bytes", text("name"), bytes.len());
        let rounded = nets.rounded().save(&card).expect("weights that can be saved");
        assert!(rounded == bytes, "{} is not rounded: run `pathlight-lab publish weights` on it", text("name"));
        println!("{}: {} bytes, {card:?}", text("name"), bytes.len());
    }
}
