//! `pathlight-lab data label`: true outcomes, the same file whether interrupted or not, and no use of test tasks on
//! request.

use std::fs;
use std::path::Path;

use pathlight::benchmark::folds::{Fold, Setup};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::sampled_paths::SampledPaths;
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{self, outcome, simulate};
use pathlight_lab::data::labels::{LabelledBalls, PATHS_LEN};
use pathlight_lab::data::random_scenes::random_scene;
use pathlight_lab::data::scene_id::SceneId;
use pathlight_lab::data::solutions::TaskSolutions;
use pathlight_lab::data::unlisted_tasks::unlisted_tasks;
use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

/// Labels balls of the first tasks of a template; returns the file.
pub fn label(folder: &Path, rounds: &str) -> String {
    let out = folder.join("labels.jsonl").display().to_string();
    output_of(&["data", "label", "--template", "2", "--limit", "6", "--rounds", rounds, "--out", &out]);
    out
}

/// Counts the balls in a file of labels that a net trained on these tasks alone may learn from: those in the tasks that
/// were not sampled around solutions of other tasks.
pub fn usable_balls(labels: &str, tasks: &[TaskId]) -> usize {
    let text = fs::read_to_string(labels).expect("labels");
    let lines = text.lines().skip(1).map(|line| serde_json::from_str::<LabelledBalls>(line).expect("a line of labels"));
    let of_tasks = lines.filter(|line| tasks.contains(&task_of(line))).flat_map(|line| line.siblings);
    of_tasks.filter(|sibling| sibling.is_none_or(|task| tasks.contains(&task))).count()
}

/// The task of a line.
fn task_of(line: &LabelledBalls) -> TaskId {
    line.scene.task().expect("not a random scene")
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
        let labels: LabelledBalls = serde_json::from_str(line).expect("a line of labels");
        let scene = labels.scene.scene().expect("a scene");
        let solves = |ball| outcome(&scene, Some(ball)).expect("a valid ball").solved;
        assert!(labels.solved.iter().all(|&ball| solves(ball)));
        assert!(!labels.failed.iter().any(|&ball| solves(ball)));
        let ball = labels.solved.iter().chain(&labels.failed).next().expect("a ball");
        let rollout = simulate(&scene, Some(*ball)).expect("a valid ball");
        let paths = SampledPaths::of(&rollout, scene.body1, scene.bodies.len()).expect("both move");
        let positions = paths.object.iter().chain(&paths.ball).flatten();
        let expected: Vec<u8> = positions.map(|at| at.round().clamp(0.0, 255.0) as u8).collect();
        assert_eq!(labels.paths.0[..PATHS_LEN], expected, "the paths of its rollout");
        (solved, failed) = (solved + labels.solved.len(), failed + labels.failed.len());
    }
    assert!(solved > 0 && failed > 0 && solved + failed == 3 * 64);
    assert_refused(&["data", "label", "--out", &half], "choose another file, or remove this one");
}

#[test]
fn labels_of_random_scenes_are_true_and_the_same_after_a_cut() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    let label = |name: &str, rounds: &str| {
        output_of(&["data", "label", "--random-scenes", "7", "--rounds", rounds, "--out", &file(name)]);
        fs::read_to_string(file(name)).expect("labels")
    };
    let whole = label("whole", "2");
    label("cut", "1");
    assert_eq!(label("cut", "2"), whole);
    let lines: Vec<LabelledBalls> =
        whole.lines().skip(1).map(|line| serde_json::from_str(line).expect("a line of labels")).collect();
    assert_eq!(
        lines.iter().map(|line| line.scene).collect::<Vec<_>>(),
        [0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6].map(SceneId::Random)
    );
    for (number, LabelledBalls { solved, failed, .. }) in (0..7).zip(&lines) {
        let scene = random_scene(number);
        let solves = |ball| outcome(&scene, Some(ball)).is_ok_and(|outcome| outcome.solved);
        assert!(solved.iter().all(|&ball| solves(ball)));
        assert!(!failed.iter().any(|&ball| solves(ball)));
        assert!(matches!(solved.len() + failed.len(), 0 | 64));
    }
    assert_ne!(lines[0].failed, lines[7].failed, "a round tries other balls");
    assert_refused(
        &["data", "label", "--random-scenes", "8", "--out", &file("cut")],
        "choose another file, or remove this one",
    );
}

#[test]
fn labels_of_unlisted_tasks_are_true_and_lie_around_no_listed_solution() {
    let folder = tempdir().expect("a folder");
    let out = folder.path().join("unlisted.jsonl").display().to_string();
    output_of(&["data", "label", "--unlisted", "3", "--template", "2", "--rounds", "2", "--out", &out]);
    let text = fs::read_to_string(&out).expect("labels");
    let lines: Vec<LabelledBalls> =
        text.lines().skip(1).map(|line| serde_json::from_str(line).expect("a line of labels")).collect();
    let scenes: Vec<SceneId> =
        unlisted_tasks(TEMPLATES[2], 3).into_iter().map(|combination| SceneId::Unlisted(2, combination)).collect();
    assert_eq!(lines.iter().map(|line| line.scene).collect::<Vec<_>>(), scenes.repeat(2));
    let balls = |line: &LabelledBalls| [&line.solved[..], &line.failed].concat();
    for (index, line) in lines.iter().enumerate() {
        let repeats = |ball: &Ball| lines[..index].iter().filter(|other| balls(other).contains(ball)).count();
        let repeated: usize = balls(line).iter().map(repeats).sum();
        assert!(repeated < 8, "{repeated} of the balls in {} were drawn before", line.scene);
    }
    for LabelledBalls { scene, solved, failed, siblings, .. } in &lines {
        let scene = scene.scene().expect("a scene");
        let solves = |&ball: &Ball| outcome(&scene, Some(ball)).is_ok_and(|outcome| outcome.solved);
        assert!(solved.iter().all(solves) && !failed.iter().any(solves));
        assert!(siblings.iter().all(Option::is_none));
    }
    // A net proposes other balls there.
    let proposed = folder.path().join("proposed.jsonl").display().to_string();
    let words = ["data", "label", "--unlisted", "3", "--template", "2", "--rounds", "1", "--out", &proposed];
    let of_net = ["--setup", "within", "--fold", "0", "--weights", "assets/within-0.safetensors"];
    output_of(&[&words[..], &of_net].concat());
    let text = fs::read_to_string(&proposed).expect("labels");
    let first: LabelledBalls = serde_json::from_str(text.lines().nth(1).expect("a line")).expect("labels");
    assert_eq!((first.scene, first.count()), (scenes[0], 64));
    assert_ne!(first.failed, lines[0].failed);
    let fewer = ["data", "label", "--unlisted", "3", "--template", "2", "--rounds", "1", "--out", &out];
    assert_refused(&fewer, "holds more rounds than 1:");
    assert_refused(&["data", "label", "--rounds", "0"], "--rounds");
    assert_refused(
        &["data", "label", "--unlisted", "4", "--template", "2", "--out", &out],
        "choose another file, or remove this one",
    );
}

#[test]
fn labels_of_a_fold_use_its_training_tasks_and_their_solutions_only() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    let solutions = fs::read_to_string(root("assets/solutions.jsonl")).expect("solutions");
    let fold = Fold::new(Setup::Within, 0);
    // The same solutions without those of test tasks.
    let without_tested = |line: &str| match serde_json::from_str::<TaskSolutions>(line) {
        Ok(mut known) if fold.test.binary_search(&known.task).is_ok() => {
            known.balls.clear();
            serde_json::to_string(&known).expect("JSON")
        }
        _ => line.to_string(),
    };
    let of_training: Vec<String> = solutions.lines().map(without_tested).collect();
    fs::write(file("training.jsonl"), of_training.join("\n") + "\n").expect("a file");
    let label = |solutions: &str, out: &str, more: &[&str]| {
        let words = ["data", "label", "--template", "2", "--limit", "12", "--rounds", "1"];
        output_of(&[&words[..], &["--solutions", solutions, "--out", &file(out)], more].concat());
        let text = fs::read_to_string(file(out)).expect("labels");
        text.lines().skip(1).map(|line| serde_json::from_str(line).expect("labels")).collect::<Vec<LabelledBalls>>()
    };
    let of_fold = label("assets/solutions.jsonl", "fold", &["--setup", "within", "--fold", "0"]);
    assert!(of_fold.len() > 3 && of_fold.len() < 12, "{} of 12 tasks", of_fold.len());
    assert!(of_fold.iter().all(|labels| fold.all_train().contains(&task_of(labels))));
    let all = label(&file("training.jsonl"), "all", &[]);
    let same: Vec<&LabelledBalls> =
        all.iter().filter(|labels| fold.test.binary_search(&task_of(labels)).is_err()).collect();
    assert_eq!(of_fold.iter().collect::<Vec<_>>(), same, "solutions of test tasks were used");
    assert_refused(&["data", "label", "--out", &file("fold")], "choose another file, or remove this one");
    let text = fs::read_to_string(file("fold")).expect("labels");
    let mut other = of_fold[0].clone();
    std::mem::swap(&mut other.solved, &mut other.failed);
    let other = text.replace(text.lines().nth(1).expect("a line"), &serde_json::to_string(&other).expect("JSON"));
    fs::write(file("other"), other).expect("a file");
    assert_refused(&["train", "success", "--labels", &file("other")], "has other outcomes than this program finds");
    assert_refused(&["data", "label", "--fold", "0", "--out", &file("half")], "--setup");
}

#[test]
fn files_that_name_unknown_tasks_or_impossible_balls_are_refused() {
    let folder = tempdir().expect("a folder");
    let write = |name: &str, lines: &[&str]| {
        let path = folder.path().join(name);
        fs::write(&path, lines.join("\n") + "\n").expect("written");
        path.display().to_string()
    };
    let settings = format!(
        r#"{{"seed":0,"per_task":1,"max_rollouts":9,"simulator":{},"template":null,"limit":1}}"#,
        simulator::VERSION
    );
    let solutions = write("solutions", &[&settings, r#"{"task":"00099:000","rollouts":1,"balls":[[100,100,10]]}"#]);
    let out = folder.path().join("out").display().to_string();
    let label = ["data", "label", "--solutions", &solutions, "--out", &out];
    assert_refused(&label, "line 2 of ");
    assert_refused(&label, "the benchmark has no task 00099:000");

    let labels = fs::read_to_string(label_file(folder.path())).expect("labels");
    let (settings, line) = labels.split_once('\n').expect("two lines");
    let refused = |labels: &str, words: &str| {
        assert_refused(&["train", "success", "--weights", "assets/within-0.safetensors", "--labels", labels], words);
    };
    let mut wrong: Value = serde_json::from_str(line.lines().next().expect("a line")).expect("labels");
    wrong["failed"][0][2] = 64.into();
    refused(&write("ball", &[settings, &wrong.to_string()]), "has a wrong radius or is not inside the scene");
    wrong["siblings"].as_array_mut().expect("a list").pop();
    refused(&write("siblings", &[settings, &wrong.to_string()]), "balls, but 63 siblings and ");
    refused(
        &write("none", &[&settings.replace("\"tasks\":2", "\"tasks\":0")]),
        "is not a file of `pathlight-lab data label`",
    );
    let older = settings.replace(&format!("\"simulator\":{}", simulator::VERSION), "\"simulator\":0");
    refused(&write("older", &[&older, line.trim_end()]), "was labelled by simulator 0");
    let of_fold = settings.replace("\"tasks\"", "\"training_tasks_of\":[\"cross\",1],\"tasks\"");
    refused(&write("fold", &[&of_fold, line.trim_end()]), "holds balls of the training tasks of cross 1");
}

/// Labels balls of two tasks; returns the file.
fn label_file(folder: &Path) -> String {
    let out = folder.join("two").display().to_string();
    output_of(&["data", "label", "--template", "2", "--limit", "2", "--rounds", "1", "--out", &out]);
    out
}
