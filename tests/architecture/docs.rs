//! The docs: the README stays short, and every link target and every named file exists.

use std::fs;
use std::path::Path;

use crate::files::{files, holds};

/// Maximum numbers of lines and words of the README.
const README_LINES: usize = 120;
const README_WORDS: usize = 1100;

/// Maximum size of a picture in the README, bytes.
const PICTURE_BYTES: u64 = 600_000;

/// Pages outside `docs/`.
const PAGES: [&str; 8] = [
    "README.md",
    "CONTRIBUTING.md",
    "CHANGELOG.md",
    "SECURITY.md",
    "examples/README.md",
    "package/README.md",
    "python/README.md",
    "www/README.md",
];

/// The folders of the repository whose files the docs name.
const FOLDERS: [&str; 14] = [
    "assets/",
    "benches/",
    "docs/",
    "examples/",
    "fuzz/",
    "lab/",
    "package/",
    "python/",
    "results/",
    "scripts/",
    "serve/",
    "src/",
    "tests/",
    "www/",
];

/// A name for the reader to choose.
const PLACEHOLDER: &str = "NAME";

struct Page {
    /// Path below the root of the repository.
    path: String,
    text: String,
}

impl Page {
    fn new(path: &str) -> Page {
        Page { path: path.to_string(), text: fs::read_to_string(root().join(path)).expect("a page") }
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn pages() -> Vec<Page> {
    let docs = files("docs", &["md"]).into_iter().map(|source| Page::new(&format!("docs/{}", source.path)));
    PAGES.iter().map(|path| Page::new(path)).chain(docs).collect()
}

#[test]
fn the_readme_is_one_screen() {
    let text = Page::new("README.md").text;
    let lines = text.lines().count();
    let words = text.split_whitespace().count();
    assert!(lines <= README_LINES, "README.md has {lines} lines, more than {README_LINES}: move some into docs/");
    assert!(words <= README_WORDS, "README.md has {words} words, more than {README_WORDS}: move some into docs/");
}

#[test]
fn the_pictures_of_the_readme_are_small() {
    let text = Page::new("README.md").text;
    let pictures: Vec<&str> = links(&text).into_iter().filter(|link| link.starts_with("assets/")).collect();
    assert!(!pictures.is_empty());
    for picture in pictures {
        let bytes = fs::metadata(root().join(picture)).expect("a picture").len();
        assert!(bytes <= PICTURE_BYTES, "{picture} has {bytes} bytes, more than {PICTURE_BYTES}");
    }
}

#[test]
fn no_link_leads_nowhere() {
    let mut broken = Vec::new();
    for page in pages() {
        let folder = Path::new(&page.path).parent().expect("a file is in a folder");
        for link in links(&page.text).into_iter().filter(|link| !link.starts_with("https://")) {
            let (file, section) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { root().join(&page.path) } else { root().join(folder).join(file) };
            let has_section =
                || fs::read_to_string(&target).is_ok_and(|text| sections(&text).contains(&section.into()));
            if !target.exists() || !section.is_empty() && !has_section() {
                broken.push(format!("{}: {link}", page.path));
            }
        }
    }
    assert!(broken.is_empty(), "\nthese links are broken:\n{}", broken.join("\n"));
}

#[test]
fn every_file_that_is_named_exists() {
    let mut missing = Vec::new();
    for page in pages() {
        let gone = named_files(&page.text).into_iter().filter(|path| !root().join(path).exists());
        missing.extend(gone.map(|path| format!("{}: {path}", page.path)));
    }
    assert!(missing.is_empty(), "\nthese named files do not exist:\n{}", missing.join("\n"));
}

#[test]
fn contributors_are_told_names_that_exist() {
    let text = Page::new("CONTRIBUTING.md").text + &Page::new("www/README.md").text;
    let is_name = |span: &&str| span.chars().all(char::is_alphanumeric) && span.contains(char::is_uppercase);
    let names: Vec<&str> = spans(&text).filter(is_name).filter(|name| *name != PLACEHOLDER).collect();
    assert!(names.len() > 5, "{names:?}");
    let sources: Vec<String> = ["src", "lab", "www"]
        .iter()
        .flat_map(|folder| files(folder, &["rs", "ts"]))
        .map(|source| source.code)
        .collect();
    let gone: Vec<&str> = names.into_iter().filter(|name| !sources.iter().any(|code| holds(code, name))).collect();
    assert!(gone.is_empty(), "these names are not in the sources: {gone:?}");
}

#[test]
fn the_packages_readme_lists_every_event() {
    let declared = Page::new("www/element.ts").text;
    let events: Vec<&str> =
        declared.lines().filter_map(|line| Some(line.trim().split_once(": CustomEvent<")?.0)).collect();
    assert!(events.len() > 2, "{events:?}");
    let readme = Page::new("package/README.md").text;
    let missing: Vec<&str> = events.into_iter().filter(|event| !readme.contains(&format!("\n| `{event}` |"))).collect();
    assert!(missing.is_empty(), "package/README.md does not list {missing:?}");
}

/// `make check` validates workflows against their schema, which does not cover our scripts.
#[test]
fn workflows_run_scripts_that_exist() {
    let makefile = Page::new("Makefile").text;
    let exists = |command: &str| match command.strip_prefix("make ") {
        Some(targets) => targets.split(' ').all(|target| makefile.contains(&format!("# make {target} "))),
        None => !command.starts_with("scripts/") || root().join(command).exists(),
    };
    assert!(exists("make package dist") && exists("scripts/check") && exists("tar dist"));
    assert!(!exists("make package gone") && !exists("scripts/gone"));
    let workflows = files(".github/workflows", &["yml"]);
    let commands =
        workflows.iter().flat_map(|source| source.text.split("run: ").skip(1)).filter_map(|rest| rest.lines().next());
    let gone: Vec<&str> = commands.filter(|command| !exists(command)).collect();
    assert!(!workflows.is_empty() && gone.is_empty(), "these do not exist: {gone:?}");
}

#[test]
fn links_sections_and_files_are_found() {
    let text = "## A title, and `more`\n[one](a.md#b) ![two\nlines](c.svg) `src/lib.rs` `lab/NAME.rs` `a/b`\n\
                ```sh\n[no](link) `src/gone.rs`\n```\n[last](#c)\n";
    assert_eq!(links(text), ["a.md#b", "c.svg", "#c"]);
    assert_eq!(sections(text), ["a-title-and-more"]);
    assert_eq!(named_files(text), ["src/lib.rs"]);
}

/// Returns the lines outside code blocks.
fn prose(text: &str) -> Vec<&str> {
    let mut in_code = false;
    let is_prose = |line: &&str| {
        let fence = line.starts_with("```");
        in_code ^= fence;
        !in_code && !fence
    };
    text.lines().filter(is_prose).collect()
}

/// Returns the targets of links and pictures.
fn links(text: &str) -> Vec<&str> {
    prose(text)
        .into_iter()
        .flat_map(|line| line.split("](").skip(1))
        .filter_map(|rest| rest.split(')').next())
        .collect()
}

/// Returns the anchors of headings.
fn sections(text: &str) -> Vec<String> {
    let headings = prose(text).into_iter().filter(|line| line.starts_with('#'));
    let name = |heading: &str| -> String {
        let words = heading.trim_start_matches('#').trim().to_lowercase();
        let kept = words.chars().filter(|&letter| letter.is_alphanumeric() || " -_".contains(letter));
        kept.map(|letter| if letter == ' ' { '-' } else { letter }).collect()
    };
    headings.map(name).collect()
}

/// Returns the code spans, which do not cross lines.
fn spans(text: &str) -> impl Iterator<Item = &str> {
    prose(text).into_iter().flat_map(|line| line.split('`').skip(1).step_by(2))
}

/// Returns the files and folders of the repository in code spans.
fn named_files(text: &str) -> Vec<&str> {
    let paths = spans(text).filter_map(|span| span.split_whitespace().next());
    paths.filter(|path| FOLDERS.iter().any(|folder| path.starts_with(folder)) && !path.contains(PLACEHOLDER)).collect()
}
