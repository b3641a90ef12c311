//! The fences between the modules: who may use what, and why.
//!
//! A grep over `src/`, comments left out. A rule is a list of words, the files that may hold them, and the reason.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::{Path, PathBuf};

struct Rule {
    words: &'static [&'static str],
    /// Files and folders (ending in `/`) below `src/`. Only these may hold the words, or all but these.
    files: Files,
    reason: &'static str,
}

enum Files {
    Only(&'static [&'static str]),
    Never(&'static [&'static str]),
}

use Files::{Never, Only};

/// What builds or decides a simulation, or chooses a ball.
const DETERMINISTIC: &[&str] = &[
    "scene.rs",
    "layout.rs",
    "templates/",
    "task.rs",
    "action.rs",
    "rollout.rs",
    "simulator.rs",
    "simulator/",
    "raster.rs",
    "placement.rs",
    "folds.rs",
    "auccess.rs",
    "game.rs",
    "overlap.rs",
    "proposer.rs",
    "solve_map.rs",
    "samples.rs",
    "solutions.rs",
];

const RULES: &[Rule] = &[
    Rule {
        words: &["rapier2d"],
        files: Only(&["simulator.rs", "simulator/"]),
        reason: "one module stands between the engine and the rest, so that the engine can change alone",
    },
    Rule {
        words: &["burn::", "use burn"],
        files: Only(&["pathnet/"]),
        reason: "the nets are used and trained through plain numbers",
    },
    Rule {
        words: &["wasm_bindgen", "js_sys", "web_sys"],
        files: Only(&["web/"]),
        reason: "everything else runs natively too, and is tested there",
    },
    Rule {
        words: &[
            "std::fs",
            "fs::",
            "std::env",
            "env::",
            "std::thread",
            "thread::",
            "std::time",
            "Instant",
            "SystemTime",
        ],
        files: Only(&["main.rs", "commands/"]),
        reason: "the library runs in a browser, which has no files, no environment and no threads, and no result may hang on a clock",
    },
    Rule {
        words: &[
            ".sin()", ".cos()", ".tan()", ".sin_cos", ".asin()", ".acos()", ".atan()", ".atan2(", ".sinh()", ".cosh()",
            ".tanh()", ".exp()", ".exp2()", ".exp_m1", ".ln()", ".ln_1p", ".log(", ".log2()", ".log10()", ".powf(",
            ".powi(", ".hypot(", ".cbrt()", "f64::sin", "f64::cos", "f64::tan", "f64::exp", "f64::ln", "f64::log",
            "f32::sin", "f32::cos", "f32::tan", "f32::exp", "f32::ln", "f32::log",
        ],
        files: Never(DETERMINISTIC),
        reason: "the standard library's differ between machines in the last bit; use libm",
    },
    Rule {
        words: &["HashMap", "HashSet"],
        files: Never(DETERMINISTIC),
        reason: "their order differs from run to run; use Vec or BTreeMap",
    },
    Rule {
        words: &["crate::web", "pathlight::web"],
        files: Only(&["web/"]),
        reason: "the page is outermost: nothing leans on it",
    },
    Rule {
        words: &["crate::commands"],
        files: Only(&["commands/"]),
        reason: "the command line is outermost: nothing leans on it",
    },
    Rule { words: &["crate::"], files: Never(&["scene.rs"]), reason: "a scene is plain data and knows nobody" },
    Rule {
        words: &[
            "crate::templates",
            "crate::task",
            "crate::simulator",
            "crate::raster",
            "crate::pathnet",
            "crate::game",
        ],
        files: Never(&["layout.rs", "action.rs", "rollout.rs"]),
        reason: "data and the layout language are what the others are made of",
    },
    Rule {
        words: &["crate::templates", "crate::task", "crate::layout", "crate::raster", "crate::pathnet", "crate::game"],
        files: Never(&["simulator.rs", "simulator/"]),
        reason: "the simulator knows scenes and balls, not where they come from or who looks at them",
    },
    Rule {
        words: &["crate::simulator"],
        files: Never(&["templates/", "task.rs", "raster.rs", "pathnet/", "placement.rs"]),
        reason: "tasks are laid out and proposals are made without simulating",
    },
    Rule {
        words: &["anyhow"],
        files: Only(&["main.rs", "commands/"]),
        reason: "the library's errors are types that a caller can match",
    },
];

#[test]
fn no_module_reaches_over_a_fence() {
    let sources = sources();
    assert!(sources.len() > 30, "only {} files found", sources.len());
    let broken: Vec<String> =
        sources.iter().flat_map(|(file, text)| RULES.iter().flat_map(move |rule| rule.broken_by(file, text))).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_rule_names_files_that_exist() {
    let sources = sources();
    // A module is a file or a folder, as it grew.
    let exists = |path: &str| {
        let stem = path.trim_end_matches('/').trim_end_matches(".rs");
        let (file, folder) = (format!("{stem}.rs"), format!("{stem}/"));
        sources.iter().any(|(name, _)| *name == file || name.starts_with(&folder))
    };
    for rule in RULES {
        let (Only(files) | Never(files)) = rule.files;
        for file in files {
            assert!(exists(file), "no src/{file}: {}", rule.reason);
        }
    }
}

#[test]
fn a_rule_finds_what_breaks_it() {
    let rule = Rule { words: &["rapier2d"], files: Only(&["simulator.rs", "simulator/"]), reason: "one module" };
    assert_eq!(rule.broken_by("game.rs", "//! no rapier2d\nuse rapier2d::prelude::*; // why\n").count(), 1);
    assert_eq!(rule.broken_by("simulator.rs", "use rapier2d::prelude::*;").count(), 0);
    assert_eq!(rule.broken_by("simulator/world.rs", "use rapier2d::prelude::*;").count(), 0);
    let rule = Rule { words: &["env::"], files: Never(&["task.rs", "templates/"]), reason: "the same everywhere" };
    assert_eq!(rule.broken_by("templates/mod.rs", "    std::env::var(name)").count(), 1);
    assert_eq!(rule.broken_by("game.rs", "std::env::var(name)").count(), 0);
    assert_eq!(rule.broken_by("task.rs", "my_env::var(name)").count(), 0);
}

#[test]
fn no_file_is_a_dumping_ground() {
    for (file, _) in sources() {
        let stem = Path::new(&file).file_stem().and_then(|stem| stem.to_str()).expect("a name");
        assert!(!["utils", "util", "helpers", "helper", "common", "misc"].contains(&stem), "src/{file}");
    }
}

impl Rule {
    fn broken_by<'a>(&'a self, file: &'a str, text: &'a str) -> impl Iterator<Item = String> + 'a {
        let named =
            |files: &[&str]| files.iter().any(|name| file == *name || name.ends_with('/') && file.starts_with(name));
        let fenced = match self.files {
            Only(files) => !named(files),
            Never(files) => named(files),
        };
        let lines = (1..).zip(text.lines()).filter(move |_| fenced);
        lines.filter_map(move |(number, line)| {
            let code = line.split("//").next().unwrap_or(line);
            let word = self.words.iter().find(|word| holds(code, word))?;
            Some(format!("src/{file}:{number}: `{word}`: {}", self.reason))
        })
    }
}

/// Whether the word is there, and not as the end of a longer name.
fn holds(code: &str, word: &str) -> bool {
    let joins = |before: char| before.is_alphanumeric() || before == '_';
    code.match_indices(word).any(|(at, _)| !(word.starts_with(joins) && code[..at].ends_with(joins)))
}

/// Path below `src/` and text of every source file.
fn sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of sources") {
            let path: PathBuf = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let name = path.strip_prefix(&root).expect("below src").to_string_lossy().replace('\\', "/");
                found.push((name, fs::read_to_string(&path).expect("source is UTF-8")));
            }
        }
    }
    found
}
