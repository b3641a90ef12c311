//! docs/commands.md is what the programs say of themselves: a section per program, made of what `-h` prints.
//!
//! The tests of the lab use this file too, for their program.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

/// A command with options, and what `-h` prints of it.
struct Page {
    words: Vec<String>,
    about: String,
    help: String,
}

/// Asserts that the section of a program is up to date. With UPDATE_GOLDEN in the environment, writes it instead.
pub fn assert_up_to_date(root: &Path, program: &str, binary: &str) {
    let file = root.join("docs/commands.md");
    let text = fs::read_to_string(&file).expect("the page");
    let heading = format!("\n## {program}\n");
    let start = text.find(&heading).expect("the program's section") + heading.len();
    let end = text[start..].find("\n## ").map_or(text.len(), |length| start + length);
    let section = section(program, &pages(binary, &[], String::new()));
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&file, format!("{}{section}{}", &text[..start], &text[end..])).expect("a file");
        return;
    }
    let written: Vec<&str> = text[start..end].lines().collect();
    let missing: Vec<&str> = section.lines().filter(|line| !written.contains(line)).collect();
    assert!(
        text[start..end] == section,
        "docs/commands.md differs from `{program} -h`: run this test again with UPDATE_GOLDEN=1. It lacks {missing:#?}"
    );
}

/// The pages of all commands below one, in the order of its help.
fn pages(binary: &str, words: &[String], about: String) -> Vec<Page> {
    let output = Command::new(binary).args(words).arg("-h").output().expect("the binary starts");
    let help = String::from_utf8(output.stdout).expect("help is UTF-8");
    let Some((_, commands)) = help.split_once("\nCommands:\n") else {
        return vec![Page { words: words.to_vec(), about, help }];
    };
    let below = rows(commands.split("\n\n").next().expect("a list")).into_iter().filter(|(name, _)| *name != "help");
    below.flat_map(|(name, about)| pages(binary, &[words, &[name.to_string()]].concat(), about.to_string())).collect()
}

fn section(program: &str, pages: &[Page]) -> String {
    let mut text = "\n| command | |\n| --- | --- |\n".to_string();
    for Page { words, about, .. } in pages {
        let anchor = format!("{program}-{}", words.join("-"));
        writeln!(text, "| [`{}`](#{anchor}) | {} |", words.join(" "), cell(about)).expect("a string");
    }
    for Page { words, help, .. } in pages {
        let (_, usage) = help.split_once("\nUsage: ").expect("help shows the usage");
        let (usage, lists) = usage.split_once('\n').expect("options follow");
        write!(text, "\n### {program} {}\n\n```sh\n{usage}\n```\n\n", words.join(" ")).expect("a string");
        text += "| argument | |\n| --- | --- |\n";
        for (argument, about) in rows(lists).into_iter().filter(|(argument, _)| *argument != "-h, --help") {
            writeln!(text, "| `{argument}` | {} |", cell(about)).expect("a string");
        }
    }
    text
}

/// The entries of a list: what stands before the first wide gap of an indented line, and what follows.
fn rows(list: &str) -> Vec<(&str, &str)> {
    let entries = list.lines().filter(|line| line.starts_with("  "));
    let parts = entries.map(|line| line.trim().split_once("  ").unwrap_or((line.trim(), "")));
    parts.map(|(name, about)| (name, about.trim())).collect()
}

/// A text as a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('<', "&lt;")
}
