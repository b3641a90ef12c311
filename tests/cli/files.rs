//! Text as people save it, and files with any name, in every command that reads them.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use tempfile::tempdir;

use crate::{output_of, run, stderr, stdout};

const BATCH: &str = "{\"task\":\"00007:008\",\"ball\":[128,200,15]}\n";

/// Every command that reads text, the argument before the file's name, and a valid text.
fn readers() -> Vec<(Vec<&'static str>, String)> {
    let scene = output_of(&["tasks", "--custom", "00007:008"]);
    let attempt = output_of(&["simulate", "--task", "00007:008", "--ball", "128,200,15", "--verifiable"]);
    vec![
        (vec!["simulate", "--batch"], BATCH.to_string()),
        (vec!["simulate", "--scene"], scene.clone()),
        (vec!["tasks", "--scene"], scene.clone()),
        (vec!["propose", "--attempts", "1", "--scene"], scene),
        (vec!["verify"], attempt),
    ]
}

#[test]
fn a_byte_order_mark_changes_nothing_and_utf16_is_named() {
    let marked = |text: &str| format!("\u{feff}{text}");
    for (mut args, text) in readers() {
        args.push("-");
        let plain = run(&args, &text);
        assert!(plain.status.success(), "{args:?}: {}", stderr(&plain));
        let output = run(&args, &marked(&text));
        assert_eq!((output.status, stdout(&output)), (plain.status, stdout(&plain)), "{args:?}: {}", stderr(&output));
        for text in [marked(&text), text] {
            let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
            let output = run(&args, &utf16);
            assert_eq!((output.status.code(), &*stdout(&output)), (Some(2), ""), "{args:?}");
            let said = stderr(&output);
            assert!(said.contains("cannot read -: this is UTF-16: save it as UTF-8"), "{args:?}: {said}");
        }
    }
    // Several files, one after another.
    let attempt = &readers()[4].1;
    assert_eq!(run(&["verify", "-"], &[marked(attempt), marked(attempt)].concat()).status.code(), Some(0));
}

#[test]
fn an_agent_skips_a_byte_order_mark_too() {
    let agent = ["agent", "--agent", "random"];
    let task = "{\"task\":\"00007:008\"}\n";
    let [plain, marked] = [task.to_string(), format!("\u{feff}{task}")].map(|text| stdout(&run(&agent, &text)));
    assert!(plain.contains("ball") && plain == marked, "{plain} {marked}");
    let output = run(&agent, &task.encode_utf16().flat_map(u16::to_be_bytes).collect::<Vec<u8>>());
    assert!(stderr(&output).contains("cannot read standard input: this is UTF-16"), "{}", stderr(&output));
}

#[cfg(unix)]
#[test]
fn a_file_may_have_any_name() {
    use std::os::unix::ffi::OsStringExt;

    let folder = tempdir().expect("a folder");
    let file = |name: &[u8]| folder.path().join(OsString::from_vec(name.to_vec()));
    let input = file(b"caf\xe9");
    for (args, text) in readers() {
        fs::write(&input, &text).expect("a file");
        let words = || args.iter().map(OsString::from).chain([input.clone().into_os_string()]);
        let output = run(&words().collect::<Vec<_>>(), "");
        assert!(output.status.success(), "{args:?}: {}", stderr(&output));
    }
    let weights = file(b"w\xe9.safetensors");
    fs::copy("assets/within-0.safetensors", &weights).expect("a file");
    let out = file(b"out\xe9");
    let words = ["propose", "--task", "00007:008", "--attempts", "1"].map(OsString::from);
    let files = ["--weights".into(), weights.into_os_string(), "--out".into(), out.clone().into_os_string()];
    let output = run(&[&words[..], &files].concat(), "");
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&out).expect("a file").lines().count(), 1);
    let memory = file(b"memory\xe9");
    let words = ["agent", "--agent", "random", "--memory"].map(OsString::from);
    let output = run(&[&words[..], &[memory.clone().into_os_string()]].concat(), "");
    assert!(output.status.success() && memory.is_file(), "{}", stderr(&output));
    assert!(Path::new(&file(b"memory\xe9.lock")).is_file());
}
