//! `pathlight-lab train paths`, and the commands that use its weights: `publish weights`, `measure evaluate`.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use pathlight::benchmark::folds::{Fold, Setup};
use pathlight::nets::read_card;
use pathlight::puzzle::task::TaskId;
use pathlight::simulator;
use pathlight_lab::data::solutions::TaskSolutions;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use super::label::usable_balls;
use super::{assert_refused, output_of};

/// A few solutions, collected once for all tests of this file.
fn solutions() -> &'static str {
    static FILE: OnceLock<(TempDir, String)> = OnceLock::new();
    let (_, file) = FILE.get_or_init(|| {
        let folder = tempdir().expect("a folder");
        let file = text(&folder.path().join("solutions.jsonl"));
        output_of(&["data", "collect", "--template", "2", "--limit", "10", "--per-task", "3", "--out", &file]);
        (folder, file)
    });
    file
}

/// A very small training run in a folder; returns the path of the weights.
fn train(folder: &Path, more: &[&str]) -> PathBuf {
    let small = ["--epochs", "2", "--batch", "4", "--checkpoint", "2", "--mirror"];
    let place = ["train", "paths", "--solutions", solutions(), "--out", &text(folder)];
    output_of(&[&place[..], &small[..], more].concat());
    folder.join("weights.safetensors")
}

fn text(path: &Path) -> String {
    path.display().to_string()
}

#[test]
fn a_run_that_was_cut_off_ends_with_the_same_weights() {
    let folder = tempdir().expect("a folder");
    let whole = train(&folder.path().join("whole"), &[]);
    let cut = train(&folder.path().join("cut"), &["--stop-after", "2"]);
    assert!(!cut.exists(), "it should have stopped before the end");
    let cut = train(&folder.path().join("cut"), &[]);
    assert_eq!(fs::read(whole).expect("weights"), fs::read(cut).expect("weights"));
    let losses = |run: &str| fs::read_to_string(folder.path().join(run).join("losses.csv")).expect("losses");
    assert!(losses("whole").lines().count() > 2);
    assert_eq!(losses("whole"), losses("cut"));
}

#[test]
fn solutions_of_an_older_simulator_are_refused() {
    let folder = tempdir().expect("a folder");
    let older = folder.path().join("older");
    let text_of = fs::read_to_string(solutions()).expect("solutions");
    let version = format!("\"simulator\":{}", simulator::VERSION);
    fs::write(&older, text_of.replace(&version, "\"simulator\":0")).expect("written");
    let train = ["train", "paths", "--solutions", &text(&older), "--out", &text(folder.path())];
    assert_refused(&train, "were found by simulator 0");
}

#[test]
fn a_part_of_the_solutions_is_refused() {
    let folder = tempdir().expect("a folder");
    let text_of = fs::read_to_string(solutions()).expect("solutions");
    let (part, _) = text_of.trim_end().rsplit_once('\n').expect("lines");
    let file = text(&folder.path().join("part.jsonl"));
    fs::write(&file, format!("{part}\n")).expect("a file");
    assert_refused(
        &["train", "paths", "--solutions", &file],
        "is not complete (tasks left: 1): finish it with `pathlight-lab data collect`",
    );
}

#[test]
fn only_its_own_checkpoints_are_removed() {
    let folder = tempdir().expect("a folder");
    let others = ["other.bpk", "best-checkpoint-nets.bpk"].map(|name| folder.path().join(name));
    for file in &others {
        fs::write(file, "of another program").expect("written");
    }
    train(folder.path(), &[]);
    assert!(others.iter().all(|file| file.exists()));
    let bpk = |file: &fs::DirEntry| file.path().extension().is_some_and(|extension| extension == "bpk");
    let left =
        fs::read_dir(folder.path()).expect("a folder").filter(|file| bpk(file.as_ref().expect("a file"))).count();
    assert_eq!(left, others.len() + 2, "and the two files of the newest checkpoint");
}

#[test]
fn the_decay_is_recorded_and_changes_the_weights() {
    let folder = tempdir().expect("a folder");
    let weights = |name: &str, more: &[&str]| fs::read(train(&folder.path().join(name), more)).expect("weights");
    let (constant, decayed) =
        (weights("constant", &["--decay-epochs", "0"]), weights("decayed", &["--decay-epochs", "2"]));
    let decay = |bytes: &[u8]| read_card(bytes).expect("a card").decay_epochs;
    assert_eq!((decay(&constant), decay(&decayed)), (0, 2));
    let losses = |name: &str| fs::read_to_string(folder.path().join(name).join("losses.csv")).expect("losses");
    assert_ne!(losses("constant"), losses("decayed"));
    assert_refused(&["train", "paths", "--epochs", "2", "--decay-epochs", "3"], "lower --decay-epochs");
}

#[test]
fn the_dev_tasks_are_for_weights_that_have_not_seen_them() {
    let folder = tempdir().expect("a folder");
    let card = |weights: &Path| read_card(&fs::read(weights).expect("weights")).expect("a card");
    let (all, without) =
        (train(&folder.path().join("all"), &[]), train(&folder.path().join("dev"), &["--without-dev"]));
    assert!(!card(&all).without_dev && card(&without).without_dev);
    let dev = Fold::new(Setup::Within, 0).dev;
    let known = fs::read_to_string(solutions()).expect("solutions");
    let tasks: Vec<TaskId> =
        known.lines().filter_map(|line| Some(serde_json::from_str::<TaskSolutions>(line).ok()?.task)).collect();
    let of_dev = tasks.iter().filter(|task| dev.contains(task)).count();
    assert!(of_dev > 0, "the check needs solutions of dev tasks");
    assert_eq!(card(&all).tasks - card(&without).tasks, of_dev);

    // The success net learns from the same tasks.
    let labels = text(&folder.path().join("labels"));
    output_of(&["data", "label", "--template", "2", "--limit", "10", "--rounds", "1", "--out", &labels]);
    let balls = |weights: &Path| {
        let out = folder.path().join("success");
        let success = ["train", "success", "--weights", &text(weights), "--labels", &labels, "--epochs", "1"];
        output_of(&[&success[..], &["--out", &text(&out)]].concat());
        let card = card(&out.join("weights.safetensors"));
        fs::remove_dir_all(out).expect("removed");
        card.success.expect("a success net").balls
    };
    let fold = Fold::new(Setup::Within, 0);
    assert_eq!(balls(&all), usable_balls(&labels, &fold.all_train()));
    assert_eq!(balls(&without), usable_balls(&labels, &fold.train));
    assert!(balls(&without) < balls(&all));

    let evaluate = |weights: &Path| {
        ["measure", "evaluate", "--dev", "--limit", "1", "--agent", "paper", "--weights", &text(weights)]
            .map(String::from)
    };
    let words = evaluate(&without);
    let table = output_of(&words.each_ref().map(String::as_str));
    assert!(table.starts_with("within, fold 0, 25 dev tasks"), "{table}");
    let words = evaluate(&all);
    assert_refused(&words.each_ref().map(String::as_str), "trained on the dev tasks too");
}

#[test]
fn another_seed_gives_other_weights_and_needs_another_folder() {
    let folder = tempdir().expect("a folder");
    let (one, two) = (folder.path().join("one"), folder.path().join("two"));
    let (first, second) = (train(&one, &[]), train(&two, &["--seed", "1"]));
    assert_ne!(fs::read(first).expect("weights"), fs::read(second).expect("weights"));
    let again = ["train", "paths", "--solutions", solutions(), "--out", &text(&one), "--seed", "1"];
    assert_refused(&again, "use another folder");
}

#[test]
fn weights_are_published_and_refused_on_folds_they_may_have_seen() {
    let folder = tempdir().expect("a folder");
    let weights = text(&train(folder.path(), &[]));

    let assets = folder.path().join("assets");
    output_of(&["publish", "weights", &weights, "--assets", &text(&assets)]);
    let list: Value = serde_json::from_slice(&fs::read(assets.join("model.json")).expect("a list")).expect("JSON");
    assert_eq!(list["models"][0]["name"], "within-0");
    assert!(assets.join(list["models"][0]["file"].as_str().expect("a file")).exists());

    let twice = ["publish", "weights", &weights, &weights, "--assets", &text(&assets)];
    assert_refused(&twice, "a second file of weights of within, fold 0");
    assert_refused(&["measure", "evaluate", "--weights", &weights, "--setup", "cross"], "trained on within 0");
    let missing = text(&folder.path().join("none.safetensors"));
    assert_refused(&["measure", "evaluate", "--weights", &missing], "name a file from `pathlight-lab train`");
}

#[test]
fn chance_is_measured_with_its_settings_beside_it() {
    let folder = tempdir().expect("a folder");
    let json = folder.path().join("new/random.json");
    let table = output_of(&["measure", "evaluate", "--agent", "random", "--limit", "1", "--json", &text(&json)]);
    assert!(table.starts_with("within, fold 0, 25 test tasks, seed 0, simulator "), "{table}");
    let report: Value = serde_json::from_slice(&fs::read(json).expect("a report")).expect("JSON");
    let score = &report["agents"][0];
    assert_eq!(score["agent"], "random");
    let firsts = score["first_solved"].as_array().expect("tasks");
    assert_eq!(firsts.len(), 25);
    let last = table.lines().last().expect("a line");
    let auccess = format!(" {:.1} ", score["auccess"].as_f64().expect("a number"));
    assert!(last.starts_with("all ") && last.contains(&auccess), "{table}");
}

#[test]
fn all_commands_read_and_write_the_shipped_solutions_unless_told_otherwise() {
    for command in [&["data", "collect"][..], &["train", "paths"], &["data", "label"]] {
        let help = output_of(&[command, &["--help"]].concat());
        assert!(help.contains("[default: assets/solutions.jsonl]"), "{command:?}: {help}");
    }
}
