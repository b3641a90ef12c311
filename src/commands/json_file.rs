//! Reads the JSON files that commands write with `--json`.

use std::fs;
use std::path::Path;

use anyhow::Context;
use serde::Deserialize;

/// Reads a file; `command` is what writes it.
///
/// # Errors
/// If it is missing or damaged.
pub fn read<T: for<'a> Deserialize<'a>>(path: &Path, command: &str) -> anyhow::Result<T> {
    let name = path.display();
    let bytes = fs::read(path).with_context(|| format!("cannot read {name}: write it with `{command}`"))?;
    serde_json::from_slice(&bytes).with_context(|| format!("{name} is damaged: write it again with `{command}`"))
}
