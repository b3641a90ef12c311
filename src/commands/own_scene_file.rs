//! Own scenes in files.

use std::fs;
use std::path::Path;

use anyhow::{Context, anyhow};
use pathlight::puzzle::own_scene::sentences;
use pathlight::session::played::Played;
use serde_json::Value;

/// Largest file, bytes. The largest scene needs some 10,000.
const MAX_SIZE: u64 = 1 << 20;

/// Reads an own scene that may be played.
///
/// # Errors
/// If the file cannot be read, is no scene, or the scene may not be played: then all reasons.
pub fn read(path: &Path) -> anyhow::Result<Played> {
    let shown = path.display();
    let size = fs::metadata(path).with_context(|| format!("cannot read {shown}"))?.len();
    anyhow::ensure!(size <= MAX_SIZE, "{shown} is larger than {MAX_SIZE} bytes, so it is no scene");
    let bytes = fs::read(path).with_context(|| format!("cannot read {shown}"))?;
    let value: Value = serde_json::from_slice(&bytes).with_context(|| format!("{shown} is no JSON"))?;
    Played::read(value).map_err(|problems| anyhow!("the scene of {shown} may not be played. {}", sentences(&problems)))
}
