//! `src/`: the order of its folders, and what each of them may not use, with the reason.

use crate::files::{Source, files, holds};
use crate::rule::{Never, Only, Rule, unknown_files};

/// The folders of `src/` from the data outwards: each uses only those before it.
const LAYERS: [&str; 13] = [
    "puzzle",
    "colour",
    "raster",
    "simulator",
    "benchmark",
    "dataset",
    "nets",
    "agents",
    "session",
    "verification",
    "search",
    "web",
    "commands",
];

/// The outermost layers: nothing uses them, not even each other.
const OUTERMOST: [&str; 2] = ["web", "commands"];

/// What builds or decides a simulation, draws data or chooses a ball: the same bits natively and in wasm.
const DETERMINISTIC: &[&str] = &[
    "puzzle/",
    "raster/",
    "simulator/",
    "benchmark/",
    "dataset/",
    "agents/",
    "session/",
    "verification.rs",
    "search/",
];

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
        words: &["md5", "rand_mt"],
        files: Only(&["puzzle/"]),
        reason: "PHYRE's shuffles and NumPy's random numbers select its tasks, and nothing of ours",
    },
    Rule {
        words: &["unsafe "],
        files: Only(&["nets/conv/matmul.rs"]),
        reason: "gemm is called by pointers; everything else is checked by the compiler",
    },
    Rule {
        words: &["println!", "eprintln!", "print!", "eprint!", "dbg!"],
        files: Only(&[]),
        reason: "the library returns what it has to say; commands use `writeln!`, because `println!` panics when nobody reads",
    },
    Rule {
        words: &["anyhow", "clap", "indicatif"],
        files: Only(&["main.rs", "commands/"]),
        reason: "the library's errors are types that a caller can match",
    },
];

#[test]
fn a_folder_uses_only_the_folders_before_it() {
    let broken: Vec<String> = sources().iter().flat_map(|source| upward_imports(&source.path, &source.code)).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_folder_has_its_place_in_the_order() {
    let sources = sources();
    let mut layers: Vec<&str> = sources.iter().filter_map(|source| layer_of(&source.path)).collect();
    layers.sort_unstable();
    layers.dedup();
    let mut expected = LAYERS.to_vec();
    expected.sort_unstable();
    assert_eq!(layers, expected, "src/ holds these folders and files beside lib.rs and main.rs");
}

#[test]
fn an_import_of_a_later_folder_is_found() {
    assert_eq!(upward_imports("nets/mod.rs", "use crate::agents::Proposal;").len(), 1);
    assert_eq!(upward_imports("nets/mod.rs", "use crate::{session::game, puzzle::task};").len(), 1);
    assert_eq!(upward_imports("nets/mod.rs", "use crate::{\n    session::game,\n    puzzle::task,\n};").len(), 1);
    assert_eq!(upward_imports("nets/mod.rs", "use crate::raster::SIDE;").len(), 0);
    assert_eq!(upward_imports("commands/tasks.rs", "use pathlight::web::Puzzle;").len(), 1);
    assert_eq!(upward_imports("commands/tasks.rs", "use pathlight::session::game;").len(), 0);
    assert_eq!(upward_imports("nets/conv/mod.rs", "use crate::nets::conv;").len(), 0);
}

#[test]
fn no_file_breaks_a_rule() {
    let sources = sources();
    assert!(sources.len() > 30, "only {} files found", sources.len());
    let broken: Vec<String> = RULES.iter().flat_map(|rule| rule.broken_by(&sources)).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_rule_names_files_that_exist() {
    let unknown = unknown_files(RULES, &sources());
    assert!(unknown.is_empty(), "\n{}", unknown.join("\n"));
}

/// The layer that a file below `src/` belongs to; none for lib.rs and main.rs.
fn layer_of(file: &str) -> Option<&str> {
    let first = file.split('/').next().unwrap_or(file);
    let stem = first.strip_suffix(".rs").unwrap_or(first);
    (!["lib", "main"].contains(&stem)).then_some(stem)
}

/// What a file uses of layers that are not before its own.
fn upward_imports(file: &str, code: &str) -> Vec<String> {
    let Some(own) = layer_of(file).and_then(|name| LAYERS.iter().position(|layer| *layer == name)) else {
        return Vec::new();
    };
    let uses = |statement: &str, layer: &str| {
        let root = if LAYERS[own] == "commands" { "pathlight" } else { "crate" };
        let grouped = statement.contains(&format!("{root}::{{")) && holds(statement, &format!("{layer}::"));
        grouped || holds(statement, &format!("{root}::{layer}"))
    };
    let mut broken = Vec::new();
    let mut number = 1;
    // Statement by statement: a grouped import may take several lines.
    for statement in code.split_inclusive(';') {
        let start = number + statement.chars().take_while(|c| c.is_whitespace()).filter(|&c| c == '\n').count();
        number += statement.matches('\n').count();
        for (index, layer) in LAYERS.iter().enumerate() {
            let allowed = index <= own && !(OUTERMOST.contains(layer) && index != own);
            if !allowed && uses(statement, layer) {
                broken.push(format!("src/{file}:{start}: `{layer}` does not come before `{}`", LAYERS[own]));
            }
        }
    }
    broken
}

fn sources() -> Vec<Source> {
    files("src", &["rs"])
}
