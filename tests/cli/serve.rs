//! `pathlight serve` is the server of the crate `pathlight-serve`, whose tests cover the served content.

use std::io::{BufRead, BufReader};
use std::process::Stdio;

use crate::{assert_refused, pathlight};

#[test]
fn the_server_prints_its_address() {
    let folder = tempfile::tempdir().expect("a folder");
    let folders = ["--dir", ".", "--assets", "."];
    let mut command = pathlight();
    command.args(["serve", "--port", "0"]).args(folders).current_dir(&folder).stdout(Stdio::piped());
    let mut child = command.spawn().expect("the binary starts");
    let mut line = String::new();
    let read = BufReader::new(child.stdout.take().expect("piped")).read_line(&mut line);
    child.kill().expect("it runs");
    child.wait().expect("it ends");
    read.expect("a line");
    assert!(line.starts_with("Pathlight is at http://127.0.0.1:"), "{line:?}");
}

#[test]
fn its_errors_are_those_of_the_other_commands() {
    assert_refused(&["serve", "--dir", "no/such/folder"], "cannot serve no/such/folder");
}
