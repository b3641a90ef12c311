//! `pathlight-lab train dqn`: the benchmark's baseline, with separate weights.

use std::fs;

use pathlight::nets::Dqn;
use serde_json::Value;
use tempfile::tempdir;

use super::label::label;
use super::{assert_refused, output_of};

#[test]
fn dqn_is_trained_alone_and_measured() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    let labels = label(folder.path(), "1");
    let train = |run: &str, more: &[&str]| {
        let words = ["train", "dqn", "--labels", &labels, "--epochs", "4", "--batch", "3", "--balls-per-scene", "8"];
        output_of(&[&words[..], &["--checkpoint", "2", "--out", &file(run)], more].concat());
        folder.path().join(run).join("weights.safetensors")
    };
    let whole = train("whole", &[]);
    let bytes = fs::read(&whole).expect("weights");
    let (_, card) = Dqn::load(&bytes).expect("weights that fit");
    assert!(card.balls > 64 && card.epochs == 4);

    let cut = train("cut", &["--stop-after", "3"]);
    assert!(!cut.exists(), "it should have stopped before the end");
    assert_eq!(fs::read(train("cut", &[])).expect("weights"), bytes, "cut off or not, the same net");

    let (weights, json) = (whole.display().to_string(), file("dqn.json"));
    let table =
        output_of(&["measure", "evaluate", "--agent", "dqn", "--dqn", &weights, "--limit", "1", "--json", &json]);
    assert!(table.contains("dqn: auccess") && table.contains("random: auccess"), "{table}");
    let report: Value = serde_json::from_slice(&fs::read(&json).expect("a report")).expect("JSON");
    assert_eq!(report["dqn"]["epochs"], 4);
    assert_eq!(report["card"], Value::Null, "the four nets are not needed");

    let measured = ["measure", "evaluate", "--agent", "dqn", "--dqn"];
    assert_refused(&[&measured[..], &[&weights, "--setup", "cross"]].concat(), "were trained on within 0");
    assert_refused(&[&measured[..], &[&weights, "--dev"]].concat(), "train dqn --without-dev");
    assert_refused(&[&measured[..], &["assets/within-0.safetensors"]].concat(), "as DQN's weights");
    assert_refused(&[&measured[..], &[&file("none")]].concat(), "run `pathlight-lab train dqn`");
}
