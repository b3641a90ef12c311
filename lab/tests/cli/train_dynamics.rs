//! `pathlight-lab train dynamics`: the net that learns from labelled balls to imagine paths and outcomes.

use std::fs;

use pathlight::nets::{LearnedFrom, Optimiser, PathNet, PathWeights};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight_lab::data::label::read_labels;
use tempfile::tempdir;

use super::label::label;
use super::{assert_refused, changed_weights, output_of, without_dynamics};

const WEIGHTS: &str = "assets/within-0.safetensors";

#[test]
fn a_dynamics_net_joins_the_weights_and_can_be_trained_further() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    let labels = label(folder.path(), "1");
    let train = |run: &str, more: &[&str]| {
        let words = ["train", "dynamics", "--labels", &labels, "--epochs", "4", "--batch", "3", "--checkpoint", "2"];
        let sizes = ["--balls-per-scene", "32", "--imagined-per-scene", "8", "--out", &file(run)];
        let weights = if more.contains(&"--weights") { &[][..] } else { &["--weights", WEIGHTS] };
        output_of(&[&words[..], &sizes, weights, more].concat());
        folder.path().join(run).join("weights.safetensors")
    };
    let whole = train("whole", &[]);
    let bytes = fs::read(&whole).expect("weights");
    let (nets, card) = PathNet::load(&bytes).expect("weights that fit");
    assert!(card.success.is_none() && card.dynamics.expect("a card").balls > 64);
    let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
    let read = nets.read(&scene).expect("a dynamics net");
    assert_eq!(nets.cell_logits(&scene).as_ref(), Some(&read.logits), "it takes the place of the success net");
    let balls = [Ball { x: 60.0, y: 200.0, r: 5.0 }, Ball { x: 200.0, y: 200.0, r: 25.0 }];
    let [left, right] = read.imagine(&balls).try_into().expect("two balls");
    assert!(left.paths.ball[0][0] < right.paths.ball[0][0], "a path begins where its ball starts");

    let success = file("success");
    output_of(&["train", "success", "--weights", WEIGHTS, "--labels", &labels, "--epochs", "1", "--out", &success]);
    let added = train("added", &["--weights", &format!("{success}/weights.safetensors")]);
    let (nets, card) = PathNet::load(&fs::read(added).expect("weights")).expect("weights that fit");
    assert!(nets.success.is_none() && card.success.is_none(), "it replaces the success net");

    let losses = |run: &str| {
        let text = fs::read_to_string(folder.path().join(run).join("losses.csv")).expect("losses");
        let last = text.lines().last().expect("a line").to_string();
        last.split(',').skip(2).map(|loss| loss.parse().expect("a number")).collect::<Vec<f32>>()
    };
    assert!(losses("whole").iter().all(|&loss| loss > 0.0));
    let cut = train("cut", &["--stop-after", "3"]);
    assert!(!cut.exists(), "it should have stopped before the end");
    assert_eq!(fs::read(train("cut", &[])).expect("weights"), bytes, "cut off or not, the same net");

    let muon = ["--optimiser", "muon"];
    let of_muon = fs::read(train("muon", &muon)).expect("weights");
    let (_, card) = PathNet::load(&of_muon).expect("weights that fit");
    assert_eq!(card.dynamics.expect("a card").optimiser, Optimiser::Muon);
    train("cut-muon", &[&muon[..], &["--stop-after", "3"]].concat());
    assert_eq!(fs::read(train("cut-muon", &muon)).expect("weights"), of_muon, "Muon continues with its momenta");

    let weighted = ["--path-weight", "2", "--solving-path-weight", "4"];
    let (_, card) = PathNet::load(&fs::read(train("weighted", &weighted)).expect("weights")).expect("weights that fit");
    assert_eq!(card.dynamics.expect("a card").path_weights, PathWeights { all: 2.0, solving: 4.0 });
    assert!(losses("weighted")[3] > 2.0 * losses("whole")[3], "the paths count four times as much");
    assert_ne!(fs::read(train("solving", &weighted[2..])).expect("weights"), bytes, "some balls solve, others do not");
    for refused in ["0", "-1", "inf", "nan", "much"] {
        let option = format!("--solving-path-weight={refused}");
        assert_refused(&["train", "dynamics", "--labels", &labels, &option], "give a number above 0");
    }

    let from = whole.display().to_string();
    let proposed = file("proposed.jsonl");
    let words =
        ["data", "label", "--template", "2", "--limit", "6", "--rounds", "1", "--setup", "within", "--fold", "0"];
    output_of(&[&words[..], &["--weights", &from, "--out", &proposed]].concat());
    let further = train("further", &["--from", &from, "--labels", &proposed]);
    assert_ne!(fs::read(further).expect("weights"), bytes);
    let random = file("random.jsonl");
    output_of(&["data", "label", "--random-scenes", "7", "--rounds", "1", "--out", &random]);
    let with_random = fs::read(train("random", &["--from", &from, "--labels", &random])).expect("weights");
    let (_, card) = PathNet::load(&with_random).expect("weights that fit");
    assert!((2..=7).contains(&card.dynamics.expect("a card").random_scenes), "number 0 and 6 at least");
    let unlisted = file("unlisted.jsonl");
    output_of(&["data", "label", "--unlisted", "2", "--rounds", "1", "--out", &unlisted]);
    let with_unlisted = fs::read(train("unlisted", &["--from", &from, "--labels", &unlisted])).expect("weights");
    let (_, card) = PathNet::load(&with_unlisted).expect("weights that fit");
    let lines = read_labels(unlisted.as_ref()).expect("labels").lines;
    let solvable = lines.iter().filter(|line| !line.solved.is_empty()).count();
    assert!((1..2 * TEMPLATES.len()).contains(&solvable), "some are solved and some are not");
    assert_eq!(card.dynamics.expect("a card").unlisted, solvable);
    for net in ["success", "dqn"] {
        assert_refused(&["train", net, "--labels", &unlisted, "--out", &file(net)], "balls in unlisted tasks");
        assert_refused(&["train", net, "--labels", &random, "--out", &file(net)], "only the dynamics net learns");
    }
    assert_refused(&["train", "dynamics", "--labels", "Cargo.toml"], "not a file of `pathlight-lab data label`");
    let dynamics = ["train", "dynamics", "--weights", WEIGHTS, "--labels", &labels];
    assert_refused(&[&dynamics[..], &["--labels", &labels]].concat(), "is named twice");
    let sizes = ["--balls-per-scene", "4", "--imagined-per-scene", "5"];
    assert_refused(&[&dynamics[..], &sizes].concat(), "lower --imagined-per-scene");
    let text = fs::read_to_string(&labels).expect("labels");
    let (cut_off, _) = text.trim_end().rsplit_once('\n').expect("lines");
    fs::write(file("cut.jsonl"), format!("{cut_off}\n")).expect("a file");
    assert_refused(&["train", "dynamics", "--weights", WEIGHTS, "--labels", &file("cut.jsonl")], "ends within a round");
    for net in ["paths", "success", "dynamics", "dqn"] {
        assert_refused(&["train", net, "--epochs", "0"], "--epochs");
    }
    let without = without_dynamics(folder.path());
    assert_refused(&["train", "dynamics", "--from", &without, "--labels", &labels], "have no dynamics net");
    let label = ["data", "label", "--out", &file("refused.jsonl"), "--fold", "0", "--weights"];
    assert_refused(&[&label[..], &[&without, "--setup", "within"]].concat(), "have no dynamics net");
    assert_refused(&[&label[..], &[&from, "--setup", "cross"]].concat(), "were trained on within 0");
    let cross = ["train", "dynamics", "--setup", "cross", "--labels", &proposed];
    assert_refused(&cross, "holds balls of the training tasks of within 0 only");
}

#[test]
fn a_net_that_has_seen_no_task_is_measured_on_any_fold_and_starts_any() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    let (random, labels) = (file("random.jsonl"), label(folder.path(), "1"));
    output_of(&["data", "label", "--random-scenes", "7", "--rounds", "1", "--out", &random]);
    let train = |run: &str, labels: &str, more: &[&str]| {
        let words =
            ["train", "dynamics", "--epochs", "1", "--batch", "4", "--balls-per-scene", "16", "--labels", labels];
        output_of(&[&words[..], &["--imagined-per-scene", "8", "--out", &file(run)], more].concat());
        let weights = file(&format!("{run}/weights.safetensors"));
        let (_, card) = PathNet::load(&fs::read(&weights).expect("weights")).expect("weights that fit");
        let card = card.dynamics.expect("a card");
        (weights, card.learned_from, card.random_scenes)
    };
    let (alone, learned_from, scenes) = train("alone", &random, &["--weights", WEIGHTS]);
    assert!(learned_from == LearnedFrom::RandomScenes && scenes > 0);
    let cross = ["--setup", "cross", "--from", &alone];
    let (more, learned_from, _) = train("more", &random, &cross);
    assert_eq!(learned_from, LearnedFrom::RandomScenes, "what it starts from has seen no task either");
    let (_, learned_from, before) = train("tasks", &labels, &["--setup", "cross", "--from", &more]);
    assert_eq!((learned_from, before), (LearnedFrom::Tasks, scenes));
    let after_tasks = ["--weights", WEIGHTS, "--from", WEIGHTS];
    assert_eq!(train("after-tasks", &random, &after_tasks).1, LearnedFrom::Tasks);

    // Nets of any fold may learn from the balls that it proposes, in random scenes and in tasks.
    let label = ["data", "label", "--rounds", "1", "--weights"];
    let (in_random, in_tasks) = (file("proposed-random.jsonl"), file("proposed-tasks.jsonl"));
    output_of(&[&label[..], &[&alone, "--random-scenes", "7", "--out", &in_random]].concat());
    let lines = read_labels(in_random.as_ref()).expect("labels").lines;
    assert_eq!((lines.len(), lines[0].count(), lines[6].count()), (7, 64, 64));
    assert!(lines[1..6].iter().all(|line| line.count() == 0 || !line.solved.is_empty()));
    assert_ne!(lines[0], read_labels(random.as_ref()).expect("labels").lines[0], "they are other balls");
    assert_eq!(train("proposed-random", &in_random, &cross).1, LearnedFrom::RandomScenes);
    output_of(&[&label[..], &[&alone, "--template", "2", "--limit", "6", "--out", &in_tasks]].concat());
    assert_eq!(train("proposed-tasks", &in_tasks, &["--from", &alone]).1, LearnedFrom::Tasks);
    assert_eq!(train("proposed-tasks-cross", &in_tasks, &cross).1, LearnedFrom::Tasks);

    // A net of unlisted tasks serves all folds within, and none across templates.
    let in_unlisted = file("unlisted.jsonl");
    let unlisted = ["--unlisted", "1", "--template", "2", "--out", &in_unlisted];
    output_of(&[&label[..], &[&alone], &unlisted[..]].concat());
    let (of_unlisted, learned_from, _) = train("of-unlisted", &in_unlisted, &["--from", &alone]);
    assert_eq!(learned_from, LearnedFrom::UnlistedTasks);
    assert_eq!(train("of-unlisted-cross", &in_unlisted, &cross).1, LearnedFrom::Tasks);
    let by_unlisted = file("by-unlisted.jsonl");
    output_of(&[&label[..], &[&of_unlisted, "--unlisted", "1", "--template", "2", "--out", &by_unlisted]].concat());
    assert_eq!(train("by-unlisted", &by_unlisted, &["--from", &of_unlisted]).1, LearnedFrom::UnlistedTasks);
    assert_refused(&["train", "dynamics", "--setup", "cross", "--labels", &by_unlisted], "unlisted tasks of every");
    let refused = ["train", "dynamics", "--setup", "cross", "--from", &of_unlisted, "--labels", &random];
    assert_refused(&refused, "were trained on within 0");
    for weights in [&of_unlisted, WEIGHTS] {
        let refused = [weights, "--random-scenes", "7", "--out", &file("refused.jsonl")];
        assert_refused(&[&label[..], &refused].concat(), "has learned from tasks");
    }
    let within_3 = ["measure", "evaluate", "--fold", "3", "--limit", "1", "--weights", &of_unlisted];
    assert!(output_of(&within_3).starts_with("within, fold 3"));

    let measure = ["measure", "evaluate", "--setup", "cross", "--fold", "3", "--limit", "1", "--weights"];
    let table = output_of(&[&measure[..], &[&alone]].concat());
    assert!(table.starts_with("cross, fold 3, 5 test tasks, seed 0") && !table.contains("paper"), "{table}");
    assert_refused(&[&measure[..], &[&alone, "--agent", "paper"]].concat(), "were trained on within 0");
    assert_refused(&[&measure[..], &[WEIGHTS]].concat(), "were trained on within 0");
}

#[test]
fn weights_without_dev_tasks_learn_from_nothing_that_knows_them() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    let labels = label(folder.path(), "1");
    let train = |words: &[&str]| {
        let (command, out) = (["train", "dynamics", "--epochs", "1", "--labels", &labels, "--out"], file("run"));
        [&command[..], &[&out], words].concat().into_iter().map(str::to_string).collect::<Vec<_>>()
    };
    let refused = |words: &[&str], why: &str| {
        assert_refused(&train(words).iter().map(String::as_str).collect::<Vec<_>>(), why);
    };
    let four = changed_weights(&folder.path().join("four"), |nets, card| {
        (nets.dynamics, card.dynamics, card.without_dev) = (None, None, true);
    });
    let with_card = |name: &str, without_dev: bool| {
        changed_weights(&folder.path().join(name), |_, card| {
            card.dynamics.as_mut().expect("a dynamics net").without_dev = without_dev;
        })
    };
    let (of_dev, honest) = (with_card("of-dev", false), with_card("honest", true));
    // Refused without --without-dev too, because the four nets have not seen dev tasks.
    refused(&["--weights", &four, "--from", &of_dev], "was trained on dev tasks");

    let proposed = |weights: &str, out: &str| {
        let words =
            ["data", "label", "--template", "2", "--limit", "6", "--rounds", "1", "--setup", "within", "--fold", "0"];
        output_of(&[&words[..], &["--weights", weights, "--out", out]].concat());
    };
    proposed(&of_dev, &file("proposed-of-dev"));
    refused(&["--weights", &four, "--labels", &file("proposed-of-dev")], "may have learned from the fold's dev tasks");
    proposed(&honest, &file("without-dev"));
    let allowed = train(&["--weights", &four, "--from", &honest, "--labels", &file("without-dev")]);
    output_of(&allowed.iter().map(String::as_str).collect::<Vec<_>>());
}
