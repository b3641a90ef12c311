//! `pathlight-lab train success`: the net that learns from labelled balls.

use std::fs;
use std::path::Path;

use pathlight::agents;
use pathlight::benchmark::folds::{Fold, Setup};
use pathlight::nets::{Optimiser, PathNet};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use tempfile::tempdir;

use super::label::{label, usable_balls};
use super::{assert_refused, output_of, root, without_dynamics};

const WEIGHTS: &str = "assets/within-0.safetensors";

#[test]
fn a_success_net_joins_the_weights_and_orders_the_attempts() {
    let folder = tempdir().expect("a folder");
    let labels = label(folder.path(), "1");
    let train = |run: &str, more: &[&str]| {
        let out = folder.path().join(run);
        let words = ["train", "success", "--weights", WEIGHTS, "--labels", &labels, "--epochs", "4", "--batch", "3"];
        output_of(&[&words[..], &["--checkpoint", "2", "--out", &out.display().to_string()], more].concat());
        out
    };
    let whole = train("whole", &[]);
    let bytes = fs::read(whole.join("weights.safetensors")).expect("weights");
    let (nets, card) = PathNet::load(&bytes).expect("weights that fit");
    assert!(nets.success.is_some());
    let training = Fold::new(Setup::Within, 0).all_train();
    let usable = usable_balls(&labels, &training);
    let all: Vec<TaskId> = Task::of(TEMPLATES[2]).map(|task| task.id).collect();
    assert!(64 < usable && usable < usable_balls(&labels, &all), "some balls tell of test tasks");
    assert_eq!(card.success.expect("a card").balls, usable, "it learns from all others");
    let cut = train("cut", &["--stop-after", "3"]);
    assert!(!cut.join("weights.safetensors").exists(), "it should have stopped before the end");
    train("cut", &[]);
    assert_eq!(fs::read(cut.join("weights.safetensors")).expect("weights"), bytes, "cut off or not, the same net");
    let losses = |run: &Path| fs::read_to_string(run.join("losses.csv")).expect("losses");
    assert_eq!(losses(&cut), losses(&whole));

    let other = without_dynamics(folder.path());
    let words = ["train", "success", "--weights", &other, "--labels", &labels, "--epochs", "4", "--batch", "3"];
    assert_refused(&[&words[..], &["--out", &cut.display().to_string()]].concat(), "a run with other --weights");
    let muon = train("muon", &["--optimiser", "muon"]).join("weights.safetensors");
    let (_, card) = PathNet::load(&fs::read(muon).expect("weights")).expect("weights that fit");
    assert_eq!(card.success.expect("a card").optimiser, Optimiser::Muon);

    let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
    let (shipped, _) = PathNet::load(&fs::read(root(WEIGHTS)).expect("weights")).expect("our own weights");
    let balls =
        |nets| agents::propose(nets, &scene, 0, 9).into_iter().map(|proposal| proposal.ball).collect::<Vec<_>>();
    assert_ne!(balls(&nets), balls(&shipped));
    assert_refused(
        &["train", "success", "--weights", WEIGHTS, "--labels", "Cargo.toml"],
        "not a file of `pathlight-lab data label`",
    );
}
