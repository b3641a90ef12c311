//! Files: journals that can be continued, and JSON.

use std::fs;
use std::path::Path;

use anyhow::Context;
use pathlight::puzzle::hex::hex;
use sha2::{Digest, Sha256};

pub mod differences;
pub mod file_lock;
pub mod journal;
pub mod json_file;

/// Returns the SHA-256 of a file, in hexadecimal.
///
/// # Errors
/// If it cannot be read.
pub fn digest(path: &Path) -> anyhow::Result<String> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(hex(Sha256::digest(bytes)))
}
