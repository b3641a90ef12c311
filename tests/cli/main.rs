//! The command line as users run it: the real binary, its output and its exit codes.
//!
//! One module per command, or per behaviour shared by several. This file runs the binary.
#![cfg(not(target_arch = "wasm32"))]

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use pathlight::nets::PathNet;
use serde_json::Value;

mod agent;
mod custom_scenes;
mod files;
mod memory;
mod pipes;
mod propose;
mod serve;
mod simulate;
mod tasks;

/// The binary, without arguments.
fn pathlight() -> Command {
    Command::new(env!("CARGO_BIN_EXE_pathlight"))
}

/// Runs the binary to its end, with this standard input.
fn run(args: &[impl AsRef<OsStr>], input: &(impl AsRef<[u8]> + ?Sized)) -> Output {
    let mut command = pathlight();
    command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the binary starts");
    let mut stdin = child.stdin.take().expect("piped");
    let input = input.as_ref().to_vec();
    // The binary may end without reading.
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the binary ends");
    writer.join().expect("the writer ends");
    output
}

/// Returns the standard output of a run that must succeed.
fn output_of(args: &[&str]) -> String {
    let output = run(args, "");
    assert!(output.status.success(), "{args:?}: {}", stderr(&output));
    stdout(&output)
}

/// Returns an answer to a JSON line without its line number, which must be `number`.
fn without_line(number: usize, answer: &str) -> Value {
    let mut answer: Value = serde_json::from_str(answer).unwrap_or_else(|error| panic!("{error}: {answer}"));
    assert_eq!(answer.as_object_mut().and_then(|keys| keys.remove("line")), Some(number.into()), "{answer}");
    answer
}

/// Asserts that a run is refused: nothing on standard output, an error that contains these words, exit code 2.
fn assert_refused(args: &[&str], words: &str) {
    let output = run(args, "");
    assert_eq!(output.status.code(), Some(2), "{args:?}: {output:?}");
    assert_eq!(stdout(&output), "", "{args:?}");
    let said = stderr(&output);
    let is_error = said.lines().any(|line| line.starts_with("error: "));
    assert!(is_error && said.contains(words), "{args:?} said {said:?} without {words:?}");
    let cause = said.trim_end().rsplit(": ").next().expect("one part at least");
    assert_eq!(said.matches(cause).count(), 1, "{args:?} said a cause twice: {said:?}");
}

/// Writes the shipped weights without their dynamics net; returns the file.
fn without_dynamics(folder: &Path) -> String {
    let bytes = fs::read("assets/within-0.safetensors").expect("weights");
    let (mut nets, mut card) = PathNet::load(&bytes).expect("our own weights");
    (nets.dynamics, card.dynamics) = (None, None);
    let out = folder.join("without-dynamics.safetensors");
    fs::write(&out, nets.save(&card).expect("weights")).expect("a file");
    out.display().to_string()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("output is UTF-8")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("messages are UTF-8")
}
