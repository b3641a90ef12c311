//! One process at a time: a file that is held cannot be held by another process, until the first one ends.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::Path;

use anyhow::{Context, bail};

/// Opens a file to append to, made if it is not there, and holds it as long as the handle lives.
///
/// # Errors
/// If another process holds it, or it cannot be opened.
pub fn hold(path: &Path) -> anyhow::Result<File> {
    let name = path.display();
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(|| format!("cannot make the folder of {name}"))?;
    }
    let file = OpenOptions::new().append(true).create(true).open(path);
    let file = file.with_context(|| format!("cannot write {name}"))?;
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => bail!("another process works on {name}: wait until it has ended"),
        // Some network file systems know no locks; there it is left to the people.
        Ok(()) | Err(TryLockError::Error(_)) => Ok(file),
    }
}
