//! A file lock: while one process holds it, others wait.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::Path;

use anyhow::Context;

use crate::progress::Progress;

/// Opens a file for reading and writing, creates it if it is missing, and locks it until the handle is dropped. If
/// another process holds the lock, this one says so and waits.
///
/// The caller must read and write through this handle only: on Windows the lock also excludes other handles.
///
/// # Errors
/// If the file cannot be opened.
pub fn lock(path: &Path, progress: &mut dyn Progress) -> anyhow::Result<File> {
    let file = open(path)?;
    // Some network file systems do not support locking; there the user must avoid concurrent runs.
    if let Err(TryLockError::WouldBlock) = file.try_lock() {
        progress.say(&format!("another process is using {}: waiting for it to end", path.display()));
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
