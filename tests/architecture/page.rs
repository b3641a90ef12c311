//! `www/`: the order of its folders, and what each of them may not use, with the reason.

use crate::files::{Source, files};
use crate::rule::{Never, Only, Rule, unknown_files};

/// The folders and files of `www/` in the order in which they import each other: each only those before it. `pkg` is
/// the wasm package, of which all may import what the API does not have. Imports in JSDoc are types only and are not
/// looked at.
const LAYERS: [&str; 18] = [
    "pkg", "api", "text", "storage", "shell", "loading", "puzzles", "state", "widgets", "model", "play", "panels",
    "editor", "attempts", "element", "home", "page", "offline",
];

/// What modules outside of `api/` may import of `pkg`: what the API does not have, because only the player needs it.
const PLAYER_ONLY: [&str; 6] = ["Game", "paintEditedScene", "palette", "paintLegend", "paintOutcomes", "paintOutline"];

const RULES: &[Rule] = &[
    Rule {
        words: &["innerHTML", "outerHTML", "insertAdjacentHTML", "document.write"],
        files: Only(&["element/markup.js", "text/translate.js"]),
        reason: "text of a link, a file or a model must not become markup",
    },
    Rule {
        words: &[
            "document.body",
            "document.getElementById",
            "document.querySelector",
            "byId(document",
            "find(document",
        ],
        files: Never(&["model/", "play/", "panels/", "editor/", "attempts/", "element/"]),
        reason: "several puzzles live in one page: each looks up its elements in its own shadow tree",
    },
    Rule {
        words: &["document", "window", "localStorage"],
        files: Never(&["api/", "model/", "state/", "shell/constants.js"]),
        reason: "it runs in the worker too, or without a page",
    },
    Rule {
        words: &["localStorage", "sessionStorage", "indexedDB", "document.cookie"],
        files: Only(&["storage/browser-store.js"]),
        reason: "one file knows how the browser stores, and what becomes of the page when it does not",
    },
    Rule {
        words: &["document.", "byId(", "pkg/pathlight.js\";", "api/index.js\";"],
        files: Never(&["storage/"]),
        reason: "what is stored is read and merged in Node too, without a page and without the wasm",
    },
    Rule {
        words: &["history.", "location."],
        files: Only(&["page/", "offline/updates.js", "loading/first-look.js"]),
        reason: "one file reads and writes the address; one looks at it before there are modules",
    },
    Rule {
        words: &["URL(\"./"],
        files: Never(&[
            "api/",
            "loading/",
            "widgets/",
            "model/",
            "play/",
            "panels/",
            "editor/",
            "attempts/",
            "element/",
            "home/",
            "page/",
        ]),
        reason: "a bundle takes the place of its entry in another folder: addresses begin with that of the folder, \"../\"",
    },
    Rule {
        words: &["new Worker("],
        files: Only(&["model/start-worker.js"]),
        reason: "one file finds the worker's code",
    },
    Rule {
        words: &["fetch("],
        files: Only(&["api/files.js", "offline/"]),
        reason: "the page works offline once the wasm, the style sheets and the weights are there",
    },
    Rule {
        words: &["caches", "serviceWorker", "navigator.locks"],
        files: Only(&["offline/"]),
        reason: "the page works without a service worker",
    },
    Rule { words: &["new Game("], files: Only(&["play/session.js"]), reason: "who makes a game frees it" },
];

#[test]
fn a_folder_imports_only_the_folders_before_it() {
    let broken: Vec<String> = sources().iter().flat_map(later_imports).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_folder_has_its_place_in_the_order() {
    let sources = sources();
    let mut layers: Vec<&str> = sources.iter().map(|source| layer_of(&source.path)).collect();
    layers.sort_unstable();
    layers.dedup();
    let mut expected = LAYERS[1..].to_vec();
    expected.sort_unstable();
    assert_eq!(layers, expected, "www/ holds these folders and scripts");
}

#[test]
fn an_import_of_a_later_folder_is_found() {
    let imports = |path, text| later_imports(&Source::new(path, text)).len();
    assert_eq!(imports("model/worker.js", "import { Session } from \"../play/session.js\";"), 1);
    assert_eq!(imports("model/worker.js", "import {\n  Session,\n} from '../play/session.js';"), 1);
    assert_eq!(imports("loading/load-wasm.js", "const page = await import(\"../page/page.js\");"), 1);
    assert_eq!(imports("widgets/dom.js", "import \"../model/map-text.js\";"), 1);
    assert_eq!(imports("panels/race.js", "import { byId } from \"../widgets/dom.js\";"), 0);
    assert_eq!(imports("panels/race.js", "import { TroubleBox } from \"./trouble-box.js\";"), 0);
    assert_eq!(imports("widgets/component.js", "/** @typedef {import(\"../play/session.js\").Session} Session */"), 0);
    assert_eq!(imports("model/worker.js", "import init from \"../pkg/pathlight.js\";"), 0);
}

#[test]
fn what_the_api_has_is_called_through_it() {
    let sources = sources();
    let outside = sources.iter().filter(|source| layer_of(&source.path) != "api");
    let past_it = outside.flat_map(|source| wasm_imports(&source.code).map(move |name| (&source.path, name)));
    let broken: Vec<_> = past_it.filter(|(_, name)| !PLAYER_ONLY.contains(name)).collect();
    assert!(broken.is_empty(), "the page has no second interface; these imports go past api/: {broken:?}");
}

#[test]
fn imports_of_the_wasm_are_found() {
    let names = |code| wasm_imports(code).collect::<Vec<_>>();
    assert_eq!(names("import { palette, templates as all } from \"../pkg/pathlight.js\";"), ["palette", "templates"]);
    assert_eq!(names("import {\n  Game,\n} from './pkg/pathlight.js';"), ["Game"]);
    assert_eq!(names("import * as wasm from \"../pkg/pathlight.js\";"), ["*"]);
    assert_eq!(names("const wasm = await import(\"../pkg/pathlight.js\");"), ["*"]);
    assert_eq!(names("import { load } from \"../api/index.js\";"), [""; 0]);
}

#[test]
fn no_file_breaks_a_rule() {
    let sources = sources();
    assert!(sources.len() > 25, "only {} files found", sources.len());
    let broken: Vec<String> = RULES.iter().flat_map(|rule| rule.broken_by(&sources)).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn every_rule_names_files_that_exist() {
    let unknown = unknown_files(RULES, &sources());
    assert!(unknown.is_empty(), "\n{}", unknown.join("\n"));
}

/// The folder below `www/`, or the file itself.
fn layer_of(path: &str) -> &str {
    path.split('/').next().unwrap_or(path)
}

/// What a module imports of layers after its own.
fn later_imports(source: &Source) -> Vec<String> {
    let place = |name: &str| LAYERS.iter().position(|layer| *layer == name);
    let own = layer_of(&source.path);
    let imported = addresses(&source.code).into_iter().map(|address| (resolved(&source.path, address), address));
    let later = imported.filter(|(path, _)| place(layer_of(path)) > place(own));
    later.map(|(_, address)| format!("www/{}: `{address}` comes after `{own}`", source.path)).collect()
}

/// The relative addresses that a module imports, statically or not.
fn addresses(code: &str) -> Vec<&str> {
    let quoted = ['"', '\''].into_iter().flat_map(|quote| {
        let openings = [format!("from {quote}"), format!("import {quote}"), format!("import({quote}")];
        openings.into_iter().flat_map(move |opening| {
            let starts = code.match_indices(&opening).map(|(at, opening)| at + opening.len()).collect::<Vec<_>>();
            starts.into_iter().filter_map(move |start| code[start..].split(quote).next())
        })
    });
    quoted.filter(|address| address.starts_with('.')).collect()
}

/// The names that a module imports of the wasm package; `*` if it imports the whole.
fn wasm_imports(code: &str) -> impl Iterator<Item = &str> {
    let statements = code.match_indices("pkg/pathlight.js").map(|(end, _)| {
        let before = &code[..end];
        &before[before.rfind("import").unwrap_or(0)..]
    });
    statements.flat_map(|statement| {
        let list = statement.split_once('{').and_then(|(_, rest)| rest.split_once('}')).map_or("*", |(list, _)| list);
        list.split(',').filter_map(|entry| entry.split_whitespace().next())
    })
}

/// The path below `www/` of an address that a file names.
fn resolved(file: &str, address: &str) -> String {
    let mut parts: Vec<&str> = file.split('/').collect();
    parts.pop();
    for part in address.split('/') {
        match part {
            "." => {}
            ".." => drop(parts.pop()),
            name => parts.push(name),
        }
    }
    parts.join("/")
}

fn sources() -> Vec<Source> {
    files("www", &["js"])
}
