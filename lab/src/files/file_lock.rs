//! A file lock: while one process holds it, any other that asks for it waits.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::Path;

use anyhow::Context;

use crate::progress::Progress;

/// Opens a file for reading and writing, creates it if it is missing, and locks it until the handle is dropped. While
/// another process holds the lock, this one waits, and says so.
///
/// The caller must read and write through this handle only: on Windows the lock also excludes other handles.
///
/// # Errors
/// If the file cannot be opened.
pub fn lock(path: &Path, progress: &mut dyn Progress) -> anyhow::Result<File> {
    let file = open(path)?;
    // Some network file systems do not support locking; there the user must avoid concurrent runs.
    if let Err(TryLockError::WouldBlock) = file.try_lock() {
        progress.say(&format!("another process uses {}: waiting until it has ended", path.display()));
        file.lock().with_context(|| format!("cannot lock {}", path.display()))?;
    }
    Ok(file)
}

fn open(path: &Path) -> anyhow::Result<File> {
    let name = path.display();
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(|| format!("cannot create the folder of {name}"))?;
    }
    let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
    file.with_context(|| format!("cannot write {name}"))
}
