//! `src/` and `lab/src/`: the order of their folders, and the words that each must not use, with the reason.

use std::collections::BTreeSet;

use crate::files::{Source, files, holds};
use crate::rule::{Never, Only, Rule, unknown_files};

/// The folders of a crate from the data outwards. Each uses only those before it.
pub struct Layers {
    /// The folder of the crate's sources.
    root: &'static str,
    /// The name of its library.
    library: &'static str,
    pub folders: &'static [&'static str],
    /// The outermost folders: nothing uses them, not even each other.
    outermost: &'static [&'static str],
}

pub const PLAYER: Layers = Layers {
    root: "src",
    library: "pathlight",
    folders: &[
        "puzzle",
        "colour",
        "raster",
        "simulator",
        "benchmark",
        "nets",
        "agents",
        "session",
        "verification",
        "search",
        "web",
        "command_line",
        "commands",
    ],
    outermost: &["web", "commands"],
};

const LAB: Layers = Layers {
    root: "lab/src",
    library: "pathlight_lab",
    folders: &["progress", "files", "data", "training", "measure", "reproduce", "figures", "commands"],
    outermost: &["commands"],
};

/// Code that builds or decides a simulation, draws data or chooses a ball. It must give the same bits natively and in
/// wasm.
const DETERMINISTIC: &[&str] =
    &["puzzle/", "raster/", "simulator/", "benchmark/", "agents/", "session/", "verification.rs", "search/"];

const RULES: &[Rule] = &[
    Rule {
        words: &["rapier2d"],
        files: Only(&["simulator/"]),
        reason: "one folder separates the engine from the rest, so that the engine can be replaced",
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
        files: Only(&["main.rs", "command_line/", "commands/"]),
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
        reason: "the standard library's results differ between machines in the last bit; use libm",
    },
    Rule {
        words: &["HashMap", "HashSet"],
        files: Never(DETERMINISTIC),
        reason: "iteration order differs from run to run; use Vec or BTreeMap",
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
        reason: "PHYRE's shuffles and NumPy's random numbers select its tasks and actions, and nothing else",
    },
    Rule {
        words: &["unsafe "],
        files: Only(&["nets/conv/matmul.rs"]),
        reason: "gemm is called with raw pointers; the compiler checks everything else",
    },
    Rule {
        words: &["println!", "eprintln!", "print!", "eprint!", "dbg!"],
        files: Only(&[]),
        reason: "the library returns values and does not print; commands use `writeln!`, because `println!` panics when nobody reads",
    },
    Rule {
        words: &["anyhow", "clap", "indicatif"],
        files: Only(&["main.rs", "command_line/", "commands/"]),
        reason: "the library's errors are types that a caller can match",
    },
    Rule { words: &["pathlight_lab"], files: Only(&[]), reason: "the player must not depend on the lab" },
];

const LAB_RULES: &[Rule] = &[
    Rule {
        words: &["clap", "indicatif"],
        files: Only(&["main.rs", "commands/"]),
        reason: "the library takes plain settings and reports its progress through a trait",
    },
    Rule {
        words: &["println!", "eprintln!", "print!", "eprint!", "dbg!", "stdout()", "stderr()"],
        files: Only(&["commands/"]),
        reason: "the library returns values or writes to a given destination",
    },
    Rule {
        words: &["burn::", "use burn", "rapier2d"],
        files: Only(&[]),
        reason: "nets and engine are used through the library of the player",
    },
    Rule {
        words: &[
            ".sin()", ".cos()", ".tan()", ".sin_cos", ".exp()", ".ln()", ".log(", ".log2()", ".log10()", ".powf(",
            ".hypot(", ".cbrt()", "f64::exp", "f64::ln", "f64::log", "HashMap", "HashSet",
        ],
        files: Never(&["data/"]),
        reason: "the same seed makes the same data on every machine: use libm, and Vec or BTreeMap",
    },
];

#[test]
fn a_folder_uses_only_the_folders_before_it() {
    for layers in [PLAYER, LAB] {
        let broken: Vec<String> =
            layers.sources().iter().flat_map(|source| layers.upward_imports(&source.path, &source.code)).collect();
        assert!(broken.is_empty(), "\n{}", broken.join("\n"));
    }
}

#[test]
fn every_folder_has_its_place_in_the_order() {
    for layers in [PLAYER, LAB] {
        let sources = layers.sources();
        let mut found: Vec<&str> = sources.iter().filter_map(|source| layer_of(&source.path)).collect();
        found.sort_unstable();
        found.dedup();
        let mut expected = layers.folders.to_vec();
        expected.sort_unstable();
        assert_eq!(found, expected, "{}/ holds these folders and files beside lib.rs and main.rs", layers.root);
    }
}

#[test]
fn an_import_of_a_later_folder_is_found() {
    let player = |file, code| PLAYER.upward_imports(file, code).len();
    assert_eq!(player("nets/mod.rs", "use crate::agents::Proposal;"), 1);
    assert_eq!(player("nets/mod.rs", "use crate::{session::turn, puzzle::task};"), 1);
    assert_eq!(player("nets/mod.rs", "use crate::{\n    session::turn,\n    puzzle::task,\n};"), 1);
    assert_eq!(player("nets/mod.rs", "use crate::raster::SIDE;"), 0);
    assert_eq!(player("commands/tasks.rs", "use pathlight::web::Model;"), 1);
    assert_eq!(player("commands/tasks.rs", "use pathlight::session::turn;"), 0);
    assert_eq!(player("nets/conv/mod.rs", "use crate::nets::conv;"), 0);
    let lab = |file, code| LAB.upward_imports(file, code).len();
    assert_eq!(lab("data/labels.rs", "use crate::training::paths;"), 1);
    assert_eq!(lab("training/paths.rs", "use crate::data::labels;"), 0);
    assert_eq!(lab("commands/train.rs", "use pathlight_lab::training::paths;"), 0);
}

#[test]
fn no_file_breaks_a_rule() {
    for (layers, rules) in [(PLAYER, RULES), (LAB, LAB_RULES)] {
        let sources = layers.sources();
        assert!(sources.len() > 30, "only {} files found", sources.len());
        let broken: Vec<String> = rules.iter().flat_map(|rule| rule.broken_by(&sources)).collect();
        assert!(broken.is_empty(), "\n{}", broken.join("\n"));
    }
}

#[test]
fn every_rule_names_files_that_exist() {
    for (layers, rules) in [(PLAYER, RULES), (LAB, LAB_RULES)] {
        let unknown = unknown_files(rules, &layers.sources());
        assert!(unknown.is_empty(), "\n{}", unknown.join("\n"));
    }
}

/// Returns the layer of a file below `src/`; none for lib.rs and main.rs.
fn layer_of(file: &str) -> Option<&str> {
    let first = file.split('/').next().unwrap_or(file);
    let stem = first.strip_suffix(".rs").unwrap_or(first);
    (!["lib", "main"].contains(&stem)).then_some(stem)
}

/// Returns whether a statement uses a folder of the library, which the statement calls `root`.
fn uses(root: &str, statement: &str, folder: &str) -> bool {
    let grouped = statement.contains(&format!("{root}::{{")) && holds(statement, &format!("{folder}::"));
    grouped || holds(statement, &format!("{root}::{folder}"))
}

impl Layers {
    fn sources(&self) -> Vec<Source> {
        files(self.root, &["rs"])
    }

    /// Returns the name by which a folder refers to the library: the commands are in the binary.
    fn root_of(&self, folder: &str) -> &'static str {
        if folder == "commands" { self.library } else { "crate" }
    }

    /// Returns the folders of the library that code uses under this name.
    pub fn used_folders<'a>(&self, root: &'a str, code: &'a str) -> impl Iterator<Item = &'static str> {
        let used = |folder: &&str| code.split(';').any(|statement| uses(root, statement, folder));
        self.folders.iter().copied().filter(used)
    }

    /// Returns the dependencies of each folder on the others, without its tests.
    pub fn imports(&self) -> BTreeSet<(String, String)> {
        let mut imports = BTreeSet::new();
        for source in self.sources() {
            let Some(own) = layer_of(&source.path) else { continue };
            let code = source.code.split("#[cfg(test)]").next().unwrap_or_default();
            let others = self.used_folders(self.root_of(own), code).filter(|folder| *folder != own);
            imports.extend(others.map(|folder| (own.to_string(), folder.to_string())));
        }
        imports
    }

    /// Returns the uses in a file of folders that do not come before its own.
    fn upward_imports(&self, file: &str, code: &str) -> Vec<String> {
        let Some(own) = layer_of(file).and_then(|name| self.folders.iter().position(|folder| *folder == name)) else {
            return Vec::new();
        };
        let root = self.root_of(self.folders[own]);
        let mut broken = Vec::new();
        let mut number = 1;
        // Statement by statement: a grouped import may take several lines.
        for statement in code.split_inclusive(';') {
            let start = number + statement.chars().take_while(|c| c.is_whitespace()).filter(|&c| c == '\n').count();
            number += statement.matches('\n').count();
            for (index, folder) in self.folders.iter().enumerate() {
                let allowed = index <= own && !(self.outermost.contains(folder) && index != own);
                if !allowed && uses(root, statement, folder) {
                    let own = self.folders[own];
                    broken.push(format!("{}/{file}:{start}: `{folder}` does not come before `{own}`", self.root));
                }
            }
        }
        broken
    }
}
