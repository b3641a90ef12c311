//! Architecture rules, checked against the source text: the order of the folders, their allowed dependencies and the
//! reasons, names, and lengths.
//!
//! `rust` has the rules of `src/` and `lab/`; `docs` and `drawing` have those of the docs and of the architecture
//! drawing. Those of the page are in `tests/www/layers.test.ts`. Comments are ignored, so a comment may name a rule.
#![cfg(not(target_arch = "wasm32"))]

use std::process::Command;

mod docs;
mod drawing;
mod files;
mod rule;
mod rust;

use files::files;

/// Maximum width of a comment, columns. rustfmt and Prettier enforce it for code but not for comments.
const MAX_COMMENT_WIDTH: usize = 120;

/// Names that do not describe the contents of a file.
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

/// Returns the numbers of the comment lines that are too wide. A URL cannot be wrapped.
fn wide_comments(text: &str) -> Vec<usize> {
    let is_comment = |line: &str| ["//", "/*", "* "].iter().any(|start| line.trim_start().starts_with(start));
    let is_wide = |line: &str| line.chars().count() > MAX_COMMENT_WIDTH && !line.contains("://");
    let lines = text.lines().enumerate();
    lines.filter(|(_, line)| is_comment(line) && is_wide(line)).map(|(index, _)| index + 1).collect()
}

/// Cargo refuses a package below a workspace unless it is a member or a workspace root.
#[test]
fn the_packages_beside_the_workspace_are_workspaces_of_their_own() {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/nets/tract/Cargo.toml");
    let mut metadata = Command::new(env!("CARGO"));
    metadata.args(["metadata", "--no-deps", "--offline", "--format-version=1", "--manifest-path", manifest]);
    let output = metadata.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
