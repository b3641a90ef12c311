//! A rule: words, the files that may hold them (or may not), and the reason.

use crate::files::{Source, holds};

pub struct Rule {
    pub words: &'static [&'static str],
    /// Files and folders (ending in `/`): either the only ones that may contain the words, or the only ones that may
    /// not.
    pub files: Files,
    pub reason: &'static str,
}

pub enum Files {
    Only(&'static [&'static str]),
    Never(&'static [&'static str]),
}

pub use Files::{Never, Only};

impl Rule {
    /// Returns a message for each line of the sources that breaks the rule.
    pub fn broken_by(&self, sources: &[Source]) -> Vec<String> {
        let applies = |path: &str| match self.files {
            Only(names) => !is_among(path, names),
            Never(names) => is_among(path, names),
        };
        let lines = (sources.iter().filter(|source| applies(&source.path)))
            .flat_map(|source| (1..).zip(source.code.lines()).map(move |(number, line)| (source, number, line)));
        let broken = lines.filter_map(|(source, number, line)| {
            let word = self.words.iter().find(|word| holds(line, word))?;
            Some(format!("{}:{number}: `{word}`: {}", source.path, self.reason))
        });
        broken.collect()
    }
}

/// Returns a message for each file or folder that the rules name and that does not exist.
pub fn unknown_files(rules: &[Rule], sources: &[Source]) -> Vec<String> {
    let named = rules.iter().flat_map(|rule| {
        let (Only(names) | Never(names)) = rule.files;
        names.iter().map(move |name| (name, rule.reason))
    });
    let unknown = named.filter(|(name, _)| !sources.iter().any(|source| is_among(&source.path, &[name])));
    unknown.map(|(name, reason)| format!("there is no {name}: {reason}")).collect()
}

fn is_among(path: &str, names: &[&str]) -> bool {
    names.iter().any(|name| path == *name || name.ends_with('/') && path.starts_with(name))
}

#[test]
fn a_rule_finds_what_breaks_it() {
    let broken = |rule: &Rule, path, text| rule.broken_by(&[Source::new(path, text)]).len();
    let rule = Rule { words: &["rapier2d"], files: Only(&["simulator/"]), reason: "one folder" };
    assert_eq!(broken(&rule, "game.rs", "//! no rapier2d\nuse rapier2d::prelude::*; // why\n"), 1);
    assert_eq!(broken(&rule, "simulator/world.rs", "use rapier2d::prelude::*;"), 0);
    let rule = Rule { words: &["env::"], files: Never(&["task.rs", "templates/"]), reason: "the same everywhere" };
    assert_eq!(broken(&rule, "templates/mod.rs", "    std::env::var(name)"), 1);
    assert_eq!(broken(&rule, "game.rs", "std::env::var(name)"), 0);
    assert_eq!(broken(&rule, "task.rs", "my_env::var(name)"), 0);
}

#[test]
fn a_rule_about_a_file_that_is_gone_is_found() {
    let sources = [Source::new("simulator/world.rs", "")];
    let rules = [Rule { words: &["a"], files: Only(&["simulator/", "engine.rs"]), reason: "one folder" }];
    assert_eq!(unknown_files(&rules, &sources), ["there is no engine.rs: one folder"]);
}
