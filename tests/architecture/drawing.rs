//! docs/architecture.svg: its boxes are the folders, and its arrows the actual dependencies.
//!
//! An arrow has a title, `A uses B`. A dependency through another folder needs no arrow.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::files::files;
use crate::rust::PLAYER;

type Arrow = (String, String);

fn drawing() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/architecture.svg")).expect("the drawing")
}

#[test]
fn the_boxes_are_the_folders() {
    let drawn: BTreeSet<String> = between(&drawing(), "<g id=\"", "\" class=").map(String::from).collect();
    let folders = PLAYER.folders.iter().chain(&["lab", "serve", "www"]);
    assert_eq!(drawn, folders.map(|folder| folder.to_string()).collect());
}

#[test]
fn the_arrows_are_what_is_used() {
    let (drawn, used) = (drawn(), used());
    let wrong: Vec<&Arrow> = drawn.difference(&used).collect();
    assert!(wrong.is_empty(), "the drawing has arrows that no import needs: {wrong:?}");
    let missing: Vec<&Arrow> = used.iter().filter(|(user, target)| !leads(&drawn, user, target)).collect();
    assert!(missing.is_empty(), "the drawing lacks arrows: {missing:?}");
}

#[test]
fn arrows_lead_through_other_folders() {
    let arrows: BTreeSet<Arrow> = [("a", "b"), ("b", "c")].map(|(user, target)| (user.into(), target.into())).into();
    assert!(leads(&arrows, "a", "c") && !leads(&arrows, "c", "a"));
}

fn drawn() -> BTreeSet<Arrow> {
    let titles = drawing();
    let arrows = between(&titles, "\"><title>", "</title>").filter_map(|title| title.split_once(" uses "));
    arrows.map(|(user, target)| (user.into(), target.into())).collect()
}

/// Returns the dependencies of each folder, without its tests.
fn used() -> BTreeSet<Arrow> {
    let mut used = PLAYER.imports();
    let mut add = |user: &str, target: &str| used.insert((user.into(), target.into()));
    for source in files("lab/src", &["rs"]) {
        for folder in PLAYER.used_folders("pathlight", &source.code) {
            add("lab", folder);
        }
    }
    if files("src/commands", &["rs"]).iter().any(|source| source.code.contains("pathlight_serve::")) {
        add("commands", "serve");
    }
    if files("www", &["ts"]).iter().any(|source| source.code.contains("/pkg/page/pathlight.js\"")) {
        add("www", "web");
    }
    used
}

/// Returns whether arrows lead from one folder to the other in any number of steps.
fn leads(arrows: &BTreeSet<Arrow>, from: &str, to: &str) -> bool {
    arrows.iter().any(|(user, target)| user == from && (target == to || leads(arrows, target, to)))
}

fn between<'a>(text: &'a str, start: &'a str, end: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(start).skip(1).filter_map(move |rest| rest.split(end).next())
}
