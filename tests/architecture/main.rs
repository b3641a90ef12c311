//! Architecture rules, checked against the source text: the order of the folders, what each may use and why, names,
//! lengths.
//!
//! `rust` has the rules of `src/` and `lab/`, `docs` and `drawing` those of the texts and the picture that people read;
//! those of the page are in `tests/www/layers.test.ts`.
//! Comments are left out, so a rule may be named in one.
#![cfg(not(target_arch = "wasm32"))]

use std::process::Command;

mod docs;
mod drawing;
mod files;
mod rule;
mod rust;

use files::files;

/// Widest line of a comment, columns: as rustfmt and Prettier hold the code to, which leave comments alone.
const MAX_COMMENT_WIDTH: usize = 120;

/// Names that say nothing of what a file holds.
const DUMPING_GROUNDS: [&str; 6] = ["utils", "util", "helpers", "helper", "common", "misc"];

#[test]
fn no_file_is_a_dumping_ground() {
    for folder in ["src", "lab", "www", "tests", "benches"] {
        for source in files(folder, &["rs", "js", "mjs", "ts"]) {
            let name = source.path.rsplit('/').next().expect("a path ends in a name");
            let stem = name.split('.').next().expect("a name begins with a stem");
            assert!(!DUMPING_GROUNDS.contains(&stem), "{folder}/{}: name it by what it holds", source.path);
        }
    }
}

#[test]
fn no_comment_is_too_wide() {
    let mut broken = Vec::new();
    for folder in ["src", "lab", "serve", "python", "www", "tests", "benches", "scripts"] {
        for source in files(folder, &["rs", "js", "mjs", "ts"]) {
            let too_wide = wide_comments(&source.text);
            broken.extend(too_wide.into_iter().map(|line| format!("{folder}/{}:{line}", source.path)));
        }
    }
    assert!(broken.is_empty(), "\nwrap these comments at {MAX_COMMENT_WIDTH} columns:\n{}", broken.join("\n"));
}

#[test]
fn a_wide_comment_is_found() {
    let words = "word ".repeat(25);
    assert_eq!(wide_comments(&format!("// {words}\n    /// {words}\n  * {words}\nlet a = \"{words}\";\n")), [1, 2, 3]);
    assert!(wide_comments(&format!("// short\n// https://a.example/{}\n", "a".repeat(120))).is_empty());
}

/// The numbers of the lines that are comments and too wide. An address cannot be wrapped.
fn wide_comments(text: &str) -> Vec<usize> {
    let is_comment = |line: &str| ["//", "/*", "* "].iter().any(|start| line.trim_start().starts_with(start));
    let is_wide = |line: &str| line.chars().count() > MAX_COMMENT_WIDTH && !line.contains("://");
    let lines = text.lines().enumerate();
    lines.filter(|(_, line)| is_comment(line) && is_wide(line)).map(|(index, _)| index + 1).collect()
}

/// Cargo refuses a package below a workspace that is neither its member nor a workspace of its own.
#[test]
fn the_packages_beside_the_workspace_are_workspaces_of_their_own() {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/nets/tract/Cargo.toml");
    let mut metadata = Command::new(env!("CARGO"));
    metadata.args(["metadata", "--no-deps", "--offline", "--format-version=1", "--manifest-path", manifest]);
    let output = metadata.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
