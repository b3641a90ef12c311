//! A reader that closes the pipe early ends any command quietly: no panic, no error, success. `verify` ends with the
//! exit code of all lines.

use std::process::{Output, Stdio};

use serde_json::json;
use tempfile::tempdir;

use super::pathlight;

/// Runs a command whose standard output nobody reads. With `both`, nobody reads its standard error either.
fn run_unread(args: &[&str], both: bool) -> Output {
    let unread = || {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        writer
    };
    let stderr = if both { Stdio::from(unread()) } else { Stdio::piped() };
    let child = pathlight().args(args).stdin(Stdio::null()).stdout(unread()).stderr(stderr).spawn();
    child.expect("the binary starts").wait_with_output().expect("the binary ends")
}

#[test]
fn commands_end_quietly_when_nobody_reads() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).display().to_string();
    std::fs::write(file("request"), json!({"task": "00000:000", "ball": null}).to_string()).expect("written");
    let commands: [&[&str]; 4] = [
        &["tasks"],
        &["simulate", "--task", "00000:000"],
        &["simulate", "--batch", &file("request")],
        &["propose", "--task", "00002:007"],
    ];
    for args in commands {
        for both in [false, true] {
            let output = run_unread(args, both);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{args:?}: {:?} {said}", output.status);
            assert!(!said.contains("panicked") && !said.contains("error"), "{args:?}: {said}");
        }
    }
    std::fs::write(file("bad"), "{}\n".repeat(2000)).expect("written");
    assert_eq!(
        run_unread(&["verify", &file("bad")], false).status.code(),
        Some(2),
        "verify says whether all are valid"
    );
}
