//! Files that are written completely or not at all.

use std::fs;
use std::path::Path;

use anyhow::Context;

/// Writes a file, and its folder if that is missing. A file that is there already stays as it is until the new one is complete.
/// A device or a pipe, which cannot be replaced, is written to.
///
/// # Errors
/// If it cannot be written; then nothing has changed.
pub fn replace_file(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let failed = || format!("cannot write {}", path.display());
    if fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
        return fs::write(path, bytes).with_context(failed);
    }
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written = folder.and_then(|()| fs::write(&part, bytes)).and_then(|()| fs::rename(&part, path));
    if written.is_err() {
        // On a full disk it would take the last room.
        let _ = fs::remove_file(&part);
    }
    written.with_context(failed)
}
