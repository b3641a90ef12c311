//! Copies trained weights to the folder from which the page loads them.
//!
//! The copies are rounded, so that each weight takes one byte instead of two, and named by setup and fold. The list
//! next to them has the hash by which the page checks a download, and the size by which it shows progress.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::command_line::replace_file::replace_file;
use pathlight::nets::PathNet;
use serde::{Deserialize, Serialize};

use crate::files::digest;

/// `model.json`.
#[derive(Serialize, Deserialize)]
pub struct ModelList {
    pub models: Vec<ModelEntry>,
}

#[derive(Serialize, Deserialize)]
pub struct ModelEntry {
    pub name: String,
    file: String,
    /// Bytes.
    size: u64,
    sha256: String,
}

/// Rounds weights, copies them to the folder from which the page loads them, and lists all weights there. Returns the
/// files that were written.
///
/// # Errors
/// If weights cannot be used, or the folder cannot be written.
pub fn publish(weights: &[PathBuf], assets: &Path) -> anyhow::Result<Vec<PathBuf>> {
    fs::create_dir_all(assets).with_context(|| format!("cannot create {}", assets.display()))?;
    // Check all before writing any.
    let mut copies: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    for path in weights {
        let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        let (nets, card) = PathNet::load(&bytes).with_context(|| format!("cannot use {}", path.display()))?;
        let copy = assets.join(format!("{}-{}.safetensors", card.setup, card.fold));
        ensure!(
            copies.iter().all(|(other, _)| *other != copy),
            "{} is a second file of weights of {}, fold {}: name one of them",
            path.display(),
            card.setup,
            card.fold
        );
        let rounded = nets.rounded().save(&card).with_context(|| format!("cannot use {}", path.display()))?;
        copies.push((copy, rounded));
    }
    let mut written = Vec::new();
    for (copy, rounded) in copies {
        replace_file(&copy, &rounded)?;
        written.push(copy);
    }
    let list = ModelList { models: entries(assets)? };
    ensure!(!list.models.is_empty(), "{} holds no weights: name a file to publish", assets.display());
    let path = assets.join("model.json");
    let mut json = serde_json::to_vec_pretty(&list)?;
    json.push(b'\n');
    replace_file(&path, &json)?;
    written.push(path);
    Ok(written)
}

/// Lists all weights in a folder, within before cross, folds ascending.
fn entries(folder: &Path) -> anyhow::Result<Vec<ModelEntry>> {
    let mut entries = Vec::new();
    for file in fs::read_dir(folder)? {
        // Names that this command writes are UTF-8.
        if let Ok(file) = file?.file_name().into_string()
            && let Some(name) = file.strip_suffix(".safetensors")
        {
            let path = folder.join(&file);
            let (size, sha256) = (fs::metadata(&path)?.len(), digest(&path)?);
            entries.push(ModelEntry { name: name.to_string(), size, sha256, file });
        }
    }
    entries.sort_by(|a, b| (a.name.starts_with("cross"), &a.name).cmp(&(b.name.starts_with("cross"), &b.name)));
    Ok(entries)
}
