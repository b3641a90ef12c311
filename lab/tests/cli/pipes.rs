//! A reader that closes the pipe early ends any command quietly: no panic, no error, success.

use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};

use tempfile::tempdir;

use super::pathlight_lab;

/// Runs a command whose standard output nobody reads; with `both`, nobody reads its standard error either.
fn run_unread(args: &[&str], both: bool) -> Output {
    let unread = || {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        writer
    };
    let stderr = if both { Stdio::from(unread()) } else { Stdio::piped() };
    let child = pathlight_lab().args(args).stdin(Stdio::null()).stdout(unread()).stderr(stderr).spawn();
    child.expect("the binary starts").wait_with_output().expect("the binary ends")
}

#[test]
fn commands_end_quietly_when_nobody_reads() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    fs::write(file("outcomes.jsonl"), "").expect("written");
    let [reference, assets, solutions, figures] = [".", "assets", "solutions", "figures"].map(file);
    let weights = "assets/within-0.safetensors";
    let commands: [&[&str]; 5] = [
        &["measure", "evaluate", "--agent", "random", "--limit", "1"],
        &["data", "collect", "--template", "2", "--limit", "1", "--per-task", "2", "--out", &solutions],
        &["publish", "weights", weights, "--assets", &assets],
        &["figures", "--out", &figures],
        &["measure", "fidelity", "--reference", &reference],
    ];
    for args in commands {
        for both in [false, true] {
            let output = run_unread(args, both);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{args:?}: {:?} {said}", output.status);
            assert!(!said.contains("panicked") && !said.contains("error"), "{args:?}: {said}");
        }
    }
    assert!(Path::new(&assets).join("model.json").exists(), "what publish writes does not depend on who reads");
    assert!(Path::new(&figures).join("README.md").exists(), "nor does what figures draws, of which this is the last");
}
