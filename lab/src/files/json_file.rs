//! The JSON files that commands write with `--json`.

use std::fs;
use std::path::Path;

use anyhow::Context;
use serde::{Deserialize, Serialize};

use super::replace_file::replace_file;

/// Reads a file; `command` is what writes it.
///
/// # Errors
/// If it is missing or damaged.
pub fn read<T: for<'a> Deserialize<'a>>(path: &Path, command: &str) -> anyhow::Result<T> {
    let name = path.display();
    let bytes = fs::read(path).with_context(|| format!("cannot read {name}: write it with `{command}`"))?;
    serde_json::from_slice(&bytes).with_context(|| format!("{name} is damaged: write it again with `{command}`"))
}

/// Writes a file, and its folder if that is missing.
///
/// # Errors
/// If it cannot be written; then nothing has changed.
pub fn write(path: &Path, value: &impl Serialize) -> anyhow::Result<()> {
    replace_file(path, &serde_json::to_vec(value)?)
}
