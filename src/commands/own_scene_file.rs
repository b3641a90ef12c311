//! Own scenes in files.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use anyhow::{Context, anyhow};
use pathlight::puzzle::own_scene::sentences;
use pathlight::session::played::Played;
use serde_json::Value;

/// Largest file, bytes. The largest scene needs some 10,000.
const MAX_SIZE: u64 = 1 << 20;

/// Reads an own scene that may be played. The path `-` is standard input.
///
/// # Errors
/// If the file cannot be read, is no scene, or the scene may not be played: then all reasons.
pub fn read(path: &Path) -> anyhow::Result<Played> {
    let shown = path.display();
    let from = |source: &mut dyn Read| {
        let mut bytes = Vec::new();
        source.take(MAX_SIZE + 1).read_to_end(&mut bytes).map(|_| bytes)
    };
    let bytes = match path.to_str() {
        Some("-") => from(&mut io::stdin()),
        _ => File::open(path).and_then(|mut file| from(&mut file)),
    };
    let bytes = bytes.with_context(|| format!("cannot read {shown}"))?;
    anyhow::ensure!(bytes.len() as u64 <= MAX_SIZE, "{shown} is larger than {MAX_SIZE} bytes, so it is not a scene");
    let value: Value = serde_json::from_slice(&bytes).with_context(|| format!("{shown} is not JSON"))?;
    Played::read(value).map_err(|problems| anyhow!("the scene of {shown} may not be played. {}", sentences(&problems)))
}
