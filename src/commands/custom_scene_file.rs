//! Custom scenes in files.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, anyhow};
use pathlight::puzzle::custom_scene::sentences;
use pathlight::puzzle::utf8::utf8;
use pathlight::session::puzzle::Puzzle;
use serde_json::Value;

use super::input;

/// Largest file, bytes. The largest scene needs about 10,000.
const MAX_SIZE: u64 = 1 << 20;

/// Reads a custom scene that can be played. The path `-` is standard input.
///
/// # Errors
///
/// If the file cannot be read or is not a scene, or if the scene cannot be played. In that case the error lists all
/// reasons.
pub fn read(path: &Path) -> anyhow::Result<Puzzle> {
    let shown = path.display();
    let cannot_read = || format!("cannot read {shown}");
    let mut bytes = Vec::new();
    input::open(path)?.take(MAX_SIZE + 1).read_to_end(&mut bytes).with_context(cannot_read)?;
    anyhow::ensure!(bytes.len() as u64 <= MAX_SIZE, "{shown} is larger than {MAX_SIZE} bytes, so it is not a scene");
    let text = utf8(&bytes).with_context(cannot_read)?;
    let value: Value = serde_json::from_str(text).with_context(|| format!("{shown} is not JSON"))?;
    Puzzle::read(value).map_err(|problems| anyhow!("the scene of {shown} cannot be played. {}", sentences(&problems)))
}
