//! `pathlight label` and `judge`: balls with their outcome, and the net that learns from them.

use std::fs;
use std::path::Path;

use pathlight::benchmark::folds::{Fold, Setup};
use pathlight::dataset::labels::Labels;
use pathlight::dataset::solutions::Solution;
use pathlight::nets::{PathNet, device};
use pathlight::puzzle::task::Task;
use pathlight::simulator::outcome;
use tempfile::tempdir;

use super::{assert_refused, output_of};

const WEIGHTS: &str = "assets/within-0.safetensors";

/// Balls of the first tasks of a template.
fn label(folder: &Path, rounds: &str) -> String {
    let out = folder.join("labels.jsonl").display().to_string();
    output_of(&["label", "--template", "2", "--limit", "6", "--rounds", rounds, "--out", &out]);
    out
}

#[test]
fn labels_are_true_and_the_same_after_a_cut() {
    let (whole, cut) = (tempdir().expect("a folder"), tempdir().expect("a folder"));
    let whole = fs::read_to_string(label(whole.path(), "2")).expect("labels");
    let half = label(cut.path(), "1");
    let text = fs::read_to_string(&half).expect("labels");
    fs::write(&half, &text[..text.len() - 20]).expect("a file");
    assert_eq!(fs::read_to_string(label(cut.path(), "2")).expect("labels"), whole);

    let (mut solved, mut failed) = (0, 0);
    for line in whole.lines().skip(1).take(3) {
        let labels: Labels = serde_json::from_str(line).expect("a line of labels");
        let scene = Task::load(labels.task).expect("a task").scene;
        let solves = |ball| outcome(&scene, Some(ball)).expect("a valid ball").solved;
        assert!(labels.solved.iter().all(|&ball| solves(ball)));
        assert!(!labels.failed.iter().any(|&ball| solves(ball)));
        (solved, failed) = (solved + labels.solved.len(), failed + labels.failed.len());
    }
    assert!(solved > 0 && failed > 0 && solved + failed == 3 * 64);
    assert_refused(&["label", "--out", &half], "name another file with --out");
}

#[test]
fn labels_of_a_fold_use_its_training_tasks_and_their_solutions_only() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    let solutions = fs::read_to_string("assets/solutions.jsonl").expect("solutions");
    let fold = Fold::new(Setup::Within, 0);
    // The same solutions without those of test tasks.
    let known = |line: &str| serde_json::from_str::<Solution>(line).ok();
    let of_training: Vec<&str> = solutions
        .lines()
        .filter(|line| known(line).is_none_or(|known| fold.test.binary_search(&known.task).is_err()))
        .collect();
    fs::write(file("training.jsonl"), of_training.join("\n") + "\n").expect("a file");
    let label = |solutions: &str, out: &str, more: &[&str]| {
        let words = ["label", "--template", "2", "--limit", "12", "--rounds", "1"];
        output_of(&[&words[..], &["--solutions", solutions, "--out", &file(out)], more].concat());
        let text = fs::read_to_string(file(out)).expect("labels");
        text.lines().skip(1).map(|line| serde_json::from_str(line).expect("labels")).collect::<Vec<Labels>>()
    };
    let of_fold = label("assets/solutions.jsonl", "fold", &["--setup", "within", "--fold", "0"]);
    assert!(of_fold.len() > 3 && of_fold.len() < 12, "{} of 12 tasks", of_fold.len());
    assert!(of_fold.iter().all(|labels| fold.all_train().contains(&labels.task)));
    let all = label(&file("training.jsonl"), "all", &[]);
    let same: Vec<&Labels> = all.iter().filter(|labels| fold.test.binary_search(&labels.task).is_err()).collect();
    assert_eq!(of_fold.iter().collect::<Vec<_>>(), same, "solutions of test tasks were used");
    assert_refused(&["label", "--out", &file("fold")], "name another file with --out");
    assert_refused(&["label", "--fold", "0", "--out", &file("half")], "--setup");
}

#[test]
fn a_judge_joins_the_weights_and_orders_the_attempts() {
    let folder = tempdir().expect("a folder");
    let labels = label(folder.path(), "1");
    let judge = |run: &str, more: &[&str]| {
        let out = folder.path().join(run);
        let words = ["judge", "--weights", WEIGHTS, "--labels", &labels, "--epochs", "4", "--batch", "3"];
        output_of(&[&words[..], &["--checkpoint", "2", "--out", &out.display().to_string()], more].concat());
        out
    };
    let whole = judge("whole", &[]);
    let out = whole.join("weights.safetensors").display().to_string();
    let bytes = fs::read(&out).expect("weights");
    let (nets, card) = PathNet::load(&bytes, &device("flex").expect("a device")).expect("weights that fit");
    assert!(nets.judge.is_some());
    assert!(card.judge.expect("a card").balls > 64);

    let cut = judge("cut", &["--stop-after", "3"]);
    assert!(!cut.join("weights.safetensors").exists(), "it was to stop before the end");
    judge("cut", &[]);
    assert_eq!(fs::read(cut.join("weights.safetensors")).expect("weights"), bytes, "cut off or not, the same judge");
    let losses = |run: &Path| fs::read_to_string(run.join("losses.csv")).expect("losses");
    assert_eq!(losses(&cut), losses(&whole));

    let propose =
        |weights: &str| output_of(&["propose", "--weights", weights, "--task", "00002:007", "--attempts", "9"]);
    assert_ne!(propose(&out), propose(WEIGHTS));
    assert_refused(&["judge", "--weights", WEIGHTS, "--labels", "Cargo.toml"], "no file of `pathlight label`");
}
