//! The compiled crates conform to `deny.toml`: licences, sources, no banned crates, and in the page only one version of
//! each. cargo-deny reads the same file, but takes longer to compile than all other test-only dependencies.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs;
use std::process::Command;

use spdx::{Expression, ParseMode};
use toml::{Table, Value};

/// A crate of `cargo tree`.
struct Crate {
    name: String,
    version: String,
    licence: String,
}

/// Returns the crates that cargo compiles for this machine and for wasm32, with these arguments.
fn tree(target: Option<&str>, args: &[&str]) -> Vec<Crate> {
    let mut command = Command::new(env::var("CARGO").unwrap_or("cargo".to_string()));
    command.args(["tree", "--locked", "--offline", "--prefix", "none", "--format", "{p}|{l}"]).args(args);
    if let Some(target) = target {
        command.args(["--target", target]);
    }
    let output = command.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let lines: BTreeSet<&str> =
        text.lines().map(|line| line.trim_end_matches(" (*)")).filter(|line| !line.is_empty()).collect();
    let of_line = |line: &str| {
        let (package, licence) = line.split_once('|').unwrap_or_else(|| panic!("no licence in {line:?}"));
        let mut words = package.split(' ');
        let mut word = || words.next().unwrap_or_default().to_string();
        Crate { name: word(), version: word(), licence: licence.to_string() }
    };
    lines.into_iter().map(of_line).collect()
}

fn compiled() -> Vec<Crate> {
    let all = ["--workspace", "--edges", "normal,build,dev"];
    [None, Some("wasm32-unknown-unknown")].into_iter().flat_map(|target| tree(target, &all)).collect()
}

fn toml(file: &str) -> Table {
    fs::read_to_string(file).expect("a file").parse().unwrap_or_else(|why| panic!("{file}: {why}"))
}

/// Returns the texts under these keys of deny.toml; for entries, the names of their crates.
fn listed(section: &str, key: &str) -> Vec<String> {
    let deny = toml("deny.toml");
    let list = deny[section][key].as_array().expect("a list").iter();
    list.map(|one| one.get("crate").unwrap_or(one).as_str().expect("a name").to_string()).collect()
}

#[test]
fn every_licence_is_allowed() {
    let allowed = listed("licenses", "allow");
    let deny = toml("deny.toml");
    let excepted = |name: &str| -> Vec<&str> {
        let exceptions = deny["licenses"]["exceptions"].as_array().expect("a list").iter();
        let own = exceptions.filter(|one| one["crate"].as_str() == Some(name));
        own.flat_map(|one| one["allow"].as_array().expect("a list")).filter_map(Value::as_str).collect()
    };
    let crates = compiled();
    assert!(crates.len() > 200, "only {} crates found", crates.len());
    for Crate { name, version, licence } in crates {
        let own = excepted(&name);
        let expression = Expression::parse_mode(&licence, ParseMode::LAX);
        let expression = expression.unwrap_or_else(|why| panic!("{name} {version}: {why}"));
        let is_allowed = expression.evaluate(|asked| {
            let asked = asked.to_string();
            allowed.contains(&asked) || own.contains(&&*asked)
        });
        assert!(is_allowed, "{name} {version} is under {licence:?}: choose another crate, or allow it in deny.toml");
    }
}

#[test]
fn no_crate_that_is_banned_is_compiled() {
    let banned = listed("bans", "deny");
    let found: Vec<String> = compiled().into_iter().map(|one| one.name).filter(|name| banned.contains(name)).collect();
    assert!(found.is_empty(), "deny.toml bans {found:?}: `cargo tree -i NAME` says who uses it");
}

#[test]
fn the_page_ships_one_version_of_each_crate() {
    let skipped = listed("bans", "skip");
    let mut versions: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let shipped = ["--package", "pathlight", "--edges", "normal,no-proc-macro"];
    for Crate { name, version, .. } in tree(Some("wasm32-unknown-unknown"), &shipped) {
        versions.entry(name).or_default().push(version);
    }
    let more: Vec<_> = versions.iter().filter(|(name, all)| all.len() > 1 && !skipped.contains(name)).collect();
    assert!(more.is_empty(), "{more:?}: update the older ones, or name them in deny.toml");
    let idle: Vec<_> = skipped.iter().filter(|name| versions.get(*name).is_none_or(|all| all.len() < 2)).collect();
    assert!(idle.is_empty(), "{idle:?} have one version: take them out of deny.toml");
}

#[test]
fn every_crate_comes_from_the_registry_with_a_checksum() {
    let registries: Vec<String> =
        listed("sources", "allow-registry").iter().map(|address| format!("registry+{address}")).collect();
    for lock in ["Cargo.lock", "fuzz/Cargo.lock"] {
        let lock = toml(lock);
        for package in lock["package"].as_array().expect("packages") {
            let name = package["name"].as_str().expect("a name");
            match package.get("source").and_then(Value::as_str) {
                None => assert!(name.starts_with("pathlight"), "{name} has no source"),
                Some(source) => {
                    assert!(registries.iter().any(|one| one == source), "{name} comes from {source}");
                    assert!(package.get("checksum").is_some(), "{name} has no checksum");
                }
            }
        }
    }
}

#[test]
fn what_trains_nets_is_compiled_for_the_lab_alone() {
    let trains = |package: &str| {
        let crates = tree(None, &["--package", package, "--edges", "normal"]);
        ["burn-autodiff", "burn-optim"].map(|name| crates.iter().any(|found| found.name == name))
    };
    assert_eq!(trains("pathlight"), [false, false]);
    assert_eq!(trains("pathlight-lab"), [true, true]);
}
