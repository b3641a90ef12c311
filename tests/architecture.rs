//! The order of the folders of `src/`, and what each of them may not use, with the reason.
//!
//! A grep over `src/`, comments left out. `LAYERS` is the order in which the folders build on each other; a rule is a
//! list of words, the folders that may hold them (or may not), and the reason.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::{Path, PathBuf};

/// The folders of `src/` from the data outwards: each uses only those before it. `raster` is a single file.
const LAYERS: [&str; 10] =
    ["puzzle", "raster", "simulator", "benchmark", "dataset", "nets", "agents", "play", "web", "commands"];

/// The outermost layers: nothing uses them, not even each other.
const OUTERMOST: [&str; 2] = ["web", "commands"];

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

/// What builds or decides a simulation, draws data or chooses a ball: the same bits natively and in wasm.
const DETERMINISTIC: &[&str] = &["puzzle/", "raster.rs", "simulator/", "benchmark/", "dataset/", "agents/", "play/"];

const RULES: &[Rule] = &[
    Rule {
        words: &["rapier2d"],
        files: Only(&["simulator/"]),
        reason: "one folder stands between the engine and the rest, so that the engine can change alone",
    },
    Rule {
        words: &["burn::", "use burn"],
        files: Only(&["nets/"]),
        reason: "the rest uses and trains nets through plain slices of f32",
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
        reason: "the library runs in a browser, which has no files, no environment and no threads, and no result may depend on a clock",
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
        words: &["crate::"],
        files: Never(&["puzzle/scene.rs"]),
        reason: "a scene is plain data and depends on nothing",
    },
    Rule {
        words: &["crate::simulator"],
        files: Never(&["nets/", "agents/"]),
        reason: "proposals are made without simulating",
    },
    Rule {
        words: &["anyhow"],
        files: Only(&["main.rs", "commands/"]),
        reason: "the library's errors are types that a caller can match",
    },
];

#[test]
fn a_folder_uses_only_the_folders_before_it() {
    let broken: Vec<String> = sources().iter().flat_map(|(file, text)| upward_imports(file, text)).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_folder_has_its_place_in_the_order() {
    let mut layers: Vec<String> = sources().iter().filter_map(|(file, _)| layer_of(file)).map(String::from).collect();
    layers.sort_unstable();
    layers.dedup();
    let mut expected = LAYERS.map(String::from).to_vec();
    expected.sort_unstable();
    assert_eq!(layers, expected, "src/ holds these folders and files beside lib.rs and main.rs");
}

#[test]
fn an_import_of_a_later_folder_is_found() {
    assert_eq!(upward_imports("nets/mod.rs", "use crate::agents::Proposal;").len(), 1);
    assert_eq!(upward_imports("nets/mod.rs", "use crate::{play::game, puzzle::task};").len(), 1);
    assert_eq!(upward_imports("nets/mod.rs", "use crate::raster::SIDE; // crate::web").len(), 0);
    assert_eq!(upward_imports("commands/tasks.rs", "use pathlight::web::Puzzle;").len(), 1);
    assert_eq!(upward_imports("commands/tasks.rs", "use pathlight::play::game;").len(), 0);
    assert_eq!(upward_imports("nets/conv/mod.rs", "use crate::nets::conv;").len(), 0);
}

#[test]
fn no_file_breaks_a_rule() {
    let sources = sources();
    assert!(sources.len() > 30, "only {} files found", sources.len());
    let broken: Vec<String> =
        sources.iter().flat_map(|(file, text)| RULES.iter().flat_map(move |rule| rule.broken_by(file, text))).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_rule_names_files_that_exist() {
    let sources = sources();
    let exists =
        |path: &str| sources.iter().any(|(name, _)| name == path || path.ends_with('/') && name.starts_with(path));
    for rule in RULES {
        let (Only(files) | Never(files)) = rule.files;
        for file in files {
            assert!(exists(file), "no src/{file}: {}", rule.reason);
        }
    }
}

#[test]
fn a_rule_finds_what_breaks_it() {
    let rule = Rule { words: &["rapier2d"], files: Only(&["simulator/"]), reason: "one folder" };
    assert_eq!(rule.broken_by("game.rs", "//! no rapier2d\nuse rapier2d::prelude::*; // why\n").count(), 1);
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

/// The layer that a file below `src/` belongs to; none for lib.rs and main.rs.
fn layer_of(file: &str) -> Option<&str> {
    let first = file.split('/').next().unwrap_or(file);
    let stem = first.strip_suffix(".rs").unwrap_or(first);
    (!["lib", "main"].contains(&stem)).then_some(stem)
}

/// What a file uses of layers that are not before its own.
fn upward_imports(file: &str, text: &str) -> Vec<String> {
    let Some(own) = layer_of(file).and_then(|name| LAYERS.iter().position(|layer| *layer == name)) else {
        return Vec::new();
    };
    let uses = |code: &str, layer: &str| {
        let root = if LAYERS[own] == "commands" { "pathlight" } else { "crate" };
        let grouped = code.contains(&format!("{root}::{{")) && holds(code, &format!("{layer}::"));
        grouped || holds(code, &format!("{root}::{layer}"))
    };
    let mut broken = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let code = line.split("//").next().unwrap_or(line);
        for (index, layer) in LAYERS.iter().enumerate() {
            let allowed = index <= own && !(OUTERMOST.contains(layer) && index != own);
            if !allowed && uses(code, layer) {
                broken.push(format!("src/{file}:{number}: `{layer}` does not come before `{}`", LAYERS[own]));
            }
        }
    }
    broken
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
