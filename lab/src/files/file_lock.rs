//! A file lock: while one process holds it, any other that asks for it is refused, or waits.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::Path;

use anyhow::{Context, bail};

use crate::progress::Progress;

/// Opens a file for reading and writing, creates it if it is missing, and locks it until the handle is dropped.
///
/// The caller must read and write through this handle only: on Windows the lock also excludes other handles.
///
/// # Errors
/// If another process holds the lock, or the file cannot be opened.
pub fn lock(path: &Path) -> anyhow::Result<File> {
    let file = open(path)?;
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => bail!("another process uses {}: wait until it has ended", path.display()),
        // Some network file systems do not support locking; there the user must avoid concurrent runs.
        Ok(()) | Err(TryLockError::Error(_)) => Ok(file),
    }
}

/// As `lock`, but waits while another process holds the lock, and says so.
///
/// # Errors
/// If the file cannot be opened.
pub fn wait_for_lock(path: &Path, progress: &mut dyn Progress) -> anyhow::Result<File> {
    let file = open(path)?;
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
