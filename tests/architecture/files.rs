//! The sources as text, with and without their comments.

use std::fs;
use std::path::Path;

pub struct Source {
    /// Path below the root, with `/`.
    pub path: String,
    pub text: String,
    /// The text without comments; lines keep their numbers.
    pub code: String,
}

impl Source {
    pub fn new(path: &str, text: &str) -> Source {
        Source { path: path.to_string(), text: text.to_string(), code: without_comments(text) }
    }
}

/// Returns all files below a folder of the repository with one of these extensions, except built or installed ones.
pub fn files(folder: &str, extensions: &[&str]) -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut found = Vec::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            let is_listed = |found: &std::ffi::OsStr| extensions.iter().any(|extension| found == *extension);
            if path.is_dir() {
                if !path.ends_with("www/pkg") && !path.ends_with("node_modules") {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(is_listed) {
                let name = path.strip_prefix(&root).expect("below the root").to_string_lossy().replace('\\', "/");
                found.push(Source::new(&name, &fs::read_to_string(&path).expect("source is UTF-8")));
            }
        }
    }
    found.sort_by(|one, other| one.path.cmp(&other.path));
    found
}

/// Returns whether the word occurs, but not as the end of a longer name.
pub fn holds(code: &str, word: &str) -> bool {
    let joins = |before: char| before.is_alphanumeric() || before == '_';
    code.match_indices(word).any(|(at, _)| !(word.starts_with(joins) && code[..at].ends_with(joins)))
}

/// Removes comments of Rust and JavaScript. A `//` in a string ends the line too early, which can only make a rule miss
/// something; the `://` of a URL does not.
fn without_comments(text: &str) -> String {
    let mut code = String::new();
    let mut in_block = false;
    for line in text.lines() {
        let mut rest = line;
        loop {
            if in_block {
                let Some(end) = rest.find("*/") else { break };
                (in_block, rest) = (false, &rest[end + 2..]);
            }
            let line_comment = rest.match_indices("//").map(|(at, _)| at).find(|&at| !rest[..at].ends_with(':'));
            match (rest.find("/*"), line_comment) {
                (Some(block), line) if line.is_none_or(|line| block < line) => {
                    code.push_str(&rest[..block]);
                    (in_block, rest) = (true, &rest[block + 2..]);
                }
                (_, Some(line)) => {
                    code.push_str(&rest[..line]);
                    break;
                }
                _ => {
                    code.push_str(rest);
                    break;
                }
            }
        }
        code.push('\n');
    }
    code
}

#[test]
fn comments_are_left_out() {
    let text =
        "//! no rapier2d\nuse a; // why\n/** @type {import(\"./b.js\").B} */ let c; /* one\ntwo */ d(\"https://e\");\n";
    assert_eq!(without_comments(text), "\nuse a; \n let c; \n d(\"https://e\");\n");
}

#[test]
fn a_word_is_not_found_at_the_end_of_a_longer_one() {
    assert!(holds("std::env::var(name)", "env::") && !holds("my_env::var(name)", "env::"));
    assert!(holds("x.powi(2)", ".powi("));
}
