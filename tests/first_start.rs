//! `make play` on a bare machine: each missing program is named, with the remedy, before anything is compiled.
#![cfg(unix)]

use std::env;
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

use tempfile::{TempDir, tempdir};

/// The commands that every system has and the scripts use.
const SYSTEM: [&str; 5] = ["bash", "cut", "dirname", "sed", "sort"];

/// A machine with only the system's commands.
struct Machine {
    programs: TempDir,
}

impl Machine {
    fn bare() -> Machine {
        let programs = tempdir().expect("a folder");
        let path = env::var_os("PATH").expect("a PATH");
        for name in SYSTEM {
            let found = env::split_paths(&path).map(|folder| folder.join(name)).find(|file| file.is_file());
            symlink(found.expect(name), programs.path().join(name)).expect("a link");
        }
        Machine { programs }
    }

    /// Adds a program with this version, which does nothing else.
    fn with(self, name: &str, version: &str) -> Machine {
        self.with_failing(name, version, 0)
    }

    /// Adds a program with this version, which does nothing and ends with this exit code.
    fn with_failing(self, name: &str, version: &str, code: i32) -> Machine {
        let file = self.programs.path().join(name);
        let script = format!("#!/usr/bin/env bash\n[[ $1 != --version ]] || printf '%s' '{version}'\nexit {code}\n");
        fs::write(&file, script).expect("a file");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).expect("its owner may");
        self
    }

    /// Asserts that the build stops at once with an error that contains these words.
    fn assert_stops(&self, words: &str) {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("scripts/build-wasm");
        let mut build = Command::new(self.programs.path().join("bash"));
        build.arg(script).env_clear().env("PATH", self.programs.path()).env("TOOLS", self.programs.path());
        let output = build.output().expect("bash runs");
        let said = String::from_utf8(output.stderr).expect("messages are UTF-8");
        assert_eq!((output.status.code(), &output.stdout[..]), (Some(2), &b""[..]), "{said}");
        assert!(said.starts_with("error: ") && said.contains(words), "{said:?} without {words:?}");
    }
}

#[test]
fn without_rust() {
    Machine::bare().assert_stops("Rust is missing: install it with rustup (https://rustup.rs)");
}

#[test]
fn with_an_old_rust() {
    let machine = Machine::bare().with("cargo", "cargo 1.60.0").with("rustc", "rustc 1.60.0 (7737e0b5c 2022-04-04)");
    machine.assert_stops("is missing: rustc 1.60.0 (7737e0b5c 2022-04-04) is too old; rustup update");
}

#[test]
fn with_rustup_but_no_toolchain() {
    let machine = Machine::bare().with_failing("cargo", "", 1).with_failing("rustc", "", 1);
    machine.assert_stops("Rust's toolchain is missing: rustup default stable");
}

#[test]
fn without_a_linker() {
    rust(Machine::bare()).assert_stops("install one (apt-get install gcc)");
}

#[test]
fn without_node() {
    let machine = rust(Machine::bare()).with("cc", "");
    machine
        .assert_stops("Node.js is missing: install version 20.16 or later 20.x, or 22.3 or later (https://nodejs.org)");
}

#[test]
fn with_an_old_node() {
    let machine = rust(Machine::bare()).with("cc", "").with_failing("node", "v18.19.0", 1);
    machine.assert_stops("Node.js 20.16 is missing: v18.19.0 is too old");
}

#[test]
fn without_npm() {
    rust(Machine::bare()).with("cc", "").with("node", "").assert_stops("npm is missing");
}

#[test]
fn without_the_wasm_target_and_without_rustup() {
    let machine = rust(Machine::bare()).with("cc", "").with("node", "").with("npm", "");
    machine.assert_stops("Rust's target wasm32-unknown-unknown is missing: install Rust with rustup");
}

fn rust(machine: Machine) -> Machine {
    machine.with("cargo", "cargo 9.0.0").with("rustc", "rustc 9.0.0 (0000000 2026-01-01)")
}
