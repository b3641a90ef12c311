//! The command line of the lab as its users run it: the real binary, its output, its exit codes.
//!
//! One module per command, or per behaviour of several commands. This file runs the binary in the root of the
//! repository.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use pathlight::nets::{Card, PathNet};

mod calibration;
mod collect;
mod figures;
mod forecasts;
mod killed;
mod label;
mod pipes;
mod reference;
mod reproduce;
mod train;
mod train_dqn;
mod train_dynamics;
mod train_success;

/// Returns the path of a file of the repository.
fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// The binary, without arguments yet.
fn pathlight_lab() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_pathlight-lab"));
    command.current_dir(root(""));
    command
}

fn run(args: &[&str]) -> Output {
    pathlight_lab().args(args).output().expect("the binary runs")
}

/// Returns the standard output of a run that must succeed.
fn output_of(args: &[&str]) -> String {
    let output = run(args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("output is UTF-8")
}

/// Asserts that a run is refused: nothing on standard output, an error that contains these words, exit code 2.
fn assert_refused(args: &[&str], words: &str) {
    let output = run(args);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {output:?}");
    assert!(output.stdout.is_empty(), "{args:?}: {output:?}");
    let said = String::from_utf8(output.stderr).expect("messages are UTF-8");
    let is_error = said.lines().any(|line| line.starts_with("error: "));
    assert!(is_error && said.contains(words), "{args:?} said {said:?} without {words:?}");
}

/// Writes the shipped weights without their dynamics net; returns the file.
fn without_dynamics(folder: &Path) -> String {
    changed_weights(&folder.join("without-dynamics.safetensors"), |nets, card| {
        (nets.dynamics, card.dynamics) = (None, None);
    })
}

/// Writes the shipped weights with a change; returns the file.
fn changed_weights(out: &Path, change: impl FnOnce(&mut PathNet, &mut Card)) -> String {
    let bytes = fs::read(root("assets/within-0.safetensors")).expect("weights");
    let (mut nets, mut card) = PathNet::load(&bytes).expect("our own weights");
    change(&mut nets, &mut card);
    fs::write(out, nets.save(&card).expect("weights")).expect("a file");
    out.display().to_string()
}
