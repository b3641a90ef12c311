//! Commands that are killed at random moments, or whose disk is full: they lose only the work since the last line or
//! checkpoint, and end with the same result as without interruption.
//!
//! PATHLIGHT_KILLS sets how often each is killed.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::Instant;

use pathlight_lab::measure::report::Report;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use tempfile::tempdir;

use super::label::label;
use super::reproduce::small_recipes;
use super::{assert_refused, output_of, pathlight_lab};

const WEIGHTS: &str = "assets/within-0.safetensors";

/// Runs a command to its end in one folder, and kills and restarts it repeatedly in another; `%` in its words stands
/// for the folder. Asserts that the result files are equal.
fn assert_survives(words: &[&str], results: &[&str]) {
    assert_same_when_killed(words, |folder| {
        results.iter().map(|file| fs::read(folder.join(file)).expect("a result")).collect()
    });
}

/// Like `assert_survives`, but compares what `read` returns for each folder.
fn assert_same_when_killed(words: &[&str], read: impl Fn(&Path) -> Vec<Vec<u8>>) {
    let kills: usize = env::var("PATHLIGHT_KILLS").map_or(3, |text| text.parse().expect("a number"));
    let (whole, killed) = (tempdir().expect("a folder"), tempdir().expect("a folder"));
    let words_in = |folder: &Path| -> Vec<String> {
        words.iter().map(|word| word.replace('%', &folder.display().to_string())).collect()
    };
    let complete = |folder: &Path| {
        let words = words_in(folder);
        output_of(&words.iter().map(String::as_str).collect::<Vec<_>>());
        read(folder)
    };
    let start = Instant::now();
    let expected = complete(whole.path());
    let duration = start.elapsed();
    let mut rng = Pcg64Mcg::seed_from_u64(50);
    let mut ended = 0;
    for _ in 0..kills {
        let mut command = pathlight_lab();
        command.args(words_in(killed.path())).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("the binary starts");
        sleep(duration.mul_f64(rng.random_range(0.0..1.0)));
        child.kill().expect("it is ours");
        let output = child.wait_with_output().expect("it ends");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!said.contains("error") && !said.contains("panicked"), "{words:?}: {said}");
        if output.status.success() {
            // Start over, so that kills hit all moments.
            ended += 1;
            for entry in fs::read_dir(killed.path()).expect("a folder") {
                let path = entry.expect("an entry").path();
                if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) }.expect("removed");
            }
        }
    }
    println!("{} {}: {kills} kills, {ended} of them too late, a run takes {duration:?}", words[0], words[1]);
    assert!(complete(killed.path()) == expected, "{words:?}: a run that was killed ended with other results");
}

#[test]
fn collect_continues_after_any_kill() {
    let few = ["--template", "2", "--limit", "60", "--per-task", "2"];
    assert_survives(&[&["data", "collect", "--out", "%/solutions.jsonl"], &few[..]].concat(), &["solutions.jsonl"]);
}

#[test]
fn label_continues_after_any_kill() {
    let few = ["--template", "2", "--limit", "40", "--rounds", "4"];
    assert_survives(&[&["data", "label", "--out", "%/labels.jsonl"], &few[..]].concat(), &["labels.jsonl"]);
}

/// Makes a few solutions and labelled balls in a folder; returns their files.
fn data(folder: &Path) -> [String; 2] {
    let solutions = folder.join("solutions.jsonl").display().to_string();
    output_of(&["data", "collect", "--template", "2", "--limit", "8", "--per-task", "2", "--out", &solutions]);
    [solutions, label(folder, "1")]
}

#[test]
fn trainings_continue_after_any_kill() {
    let folder = tempdir().expect("a folder");
    let [solutions, labels] = data(folder.path());
    let results = ["run/weights.safetensors", "run/losses.csv"];
    let small = ["--epochs", "2", "--batch", "4", "--checkpoint", "1", "--out", "%/run"];
    assert_survives(&[&["train", "paths", "--solutions", &solutions], &small[..]].concat(), &results);
    let of_labels = ["--labels", &labels, "--balls-per-scene", "32"];
    assert_survives(&[&["train", "dqn"], &of_labels[..], &small].concat(), &results);
    let of_weights = [&["--weights", WEIGHTS], &of_labels[..]].concat();
    assert_survives(&[&["train", "success"], &of_weights[..], &small].concat(), &results);
    let imagined = ["--imagined-per-scene", "8"];
    assert_survives(&[&["train", "dynamics"], &of_weights[..], &imagined, &small].concat(), &results);
}

#[test]
fn reproduce_continues_after_any_kill() {
    let folder = tempdir().expect("a folder");
    let recipes = small_recipes(folder.path());
    let fold = ["reproduce", "--recipe", "small", "--setup", "cross", "--fold", "0", "--recipes", &recipes];
    assert_same_when_killed(&[&fold[..], &["--results", "%/results", "--runs", "%/runs"]].concat(), |folder| {
        // Results also record how long they took, so they are not compared byte by byte.
        let weights = fs::read(folder.join("runs/nets/cross-0/weights.safetensors")).expect("weights");
        let result = Report::read(&folder.join("results/small/cross-0.json"), "").expect("a result");
        vec![weights, result.table().expect("a table").into_bytes()]
    });
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_said_and_loses_nothing() {
    use std::process::Command;

    let disk = tempdir().expect("a folder");
    let mount = |options: &str| {
        let words = ["-t", "tmpfs", "-o", options, "tmpfs"];
        Command::new("mount").args(words).arg(disk.path()).output().is_ok_and(|output| output.status.success())
    };
    if !mount("size=64k") {
        println!("not tried: only root may mount a disk of 64 kB");
        return;
    }
    let data = tempdir().expect("a folder");
    let few_solutions = data.path().join("solutions.jsonl").display().to_string();
    output_of(&["data", "collect", "--template", "2", "--limit", "4", "--per-task", "2", "--out", &few_solutions]);
    let out = disk.path().join("labels.jsonl").display().to_string();
    let words = ["data", "label", "--template", "2", "--limit", "40", "--rounds", "4", "--out", &out];
    let full = std::panic::catch_unwind(|| {
        assert_refused(&words, "cannot write");
        assert!(fs::metadata(&out).expect("its lines").len() > 0);
        let solutions = disk.path().join("solutions.jsonl").display().to_string();
        let few = ["--template", "2", "--limit", "20", "--per-task", "2"];
        assert_refused(&[&["data", "collect", "--out", &solutions], &few[..]].concat(), "cannot write");
        let run = disk.path().join("run").display().to_string();
        assert_refused(
            &["train", "paths", "--solutions", &few_solutions, "--checkpoint", "1", "--out", &run],
            "cannot write",
        );
        // With free space again, the command continues after the lines already written.
        fs::remove_file(&solutions).expect("removed");
        assert!(mount("remount,size=4m"));
        output_of(&words);
        let whole = tempdir().expect("a folder");
        let other = whole.path().join("labels.jsonl").display().to_string();
        output_of(&[&words[..9], &[&*other]].concat());
        assert!(fs::read(&out).expect("labels") == fs::read(other).expect("labels"));
    });
    let unmounted = Command::new("umount").arg(disk.path()).status().expect("umount runs");
    assert!(unmounted.success());
    full.expect("as on any disk");
}

#[test]
fn a_folder_that_cannot_be_written_is_said() {
    let folder = tempdir().expect("a folder");
    // Use a file where a folder is expected, because root may write into any folder.
    let file = folder.path().join("file").display().to_string();
    fs::write(&file, "of somebody").expect("written");
    let inside = format!("{file}/inside");
    let inside_of_it = format!("{inside}/out.jsonl");
    assert_refused(
        &["data", "collect", "--template", "2", "--limit", "1", "--out", &inside_of_it],
        "cannot create the folder of",
    );
    assert_refused(
        &["data", "label", "--template", "2", "--limit", "1", "--out", &inside_of_it],
        "cannot create the folder of",
    );
    let solutions = folder.path().join("solutions.jsonl").display().to_string();
    output_of(&["data", "collect", "--template", "2", "--limit", "4", "--per-task", "2", "--out", &solutions]);
    assert_refused(&["train", "paths", "--solutions", &solutions, "--out", &inside], "cannot create the folder of");
    let labels = label(folder.path(), "1");
    for net in ["success", "dynamics"] {
        assert_refused(
            &["train", net, "--weights", WEIGHTS, "--labels", &labels, "--out", &inside],
            "cannot create the folder of",
        );
    }
    assert_eq!(fs::read_to_string(&file).expect("a file"), "of somebody");
}
