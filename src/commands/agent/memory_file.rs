//! The file that keeps what puzzles with "remember" teach. One process at a time uses it.

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use pathlight::agents::memory::Memory;

pub struct MemoryFile {
    file: PathBuf,
    /// Beside it: the file itself is replaced when it is written.
    lock_file: PathBuf,
    _lock: File,
    /// SHA-256 of the weights that the memory is learned with.
    weights: Option<String>,
    /// What the file holds.
    written: String,
}

impl MemoryFile {
    /// Opens the file, and reads the memory that it holds; an empty one if it is not there yet.
    ///
    /// # Errors
    /// If another process uses it, it cannot be read or written, or does not hold a memory of these weights.
    pub fn open(path: &Path, weights: Option<String>) -> anyhow::Result<(MemoryFile, Memory)> {
        let name = path.display();
        // A link goes on leading to the file.
        let file = path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        let lock_file = beside(&file, ".lock");
        let lock = File::create(&lock_file).with_context(|| format!("cannot write the memory to {name}"))?;
        if let Err(TryLockError::WouldBlock) = lock.try_lock() {
            bail!("another process uses the memory in {name}: wait until it has ended, or name another file");
        }
        let mut opened = MemoryFile { file, lock_file, _lock: lock, weights, written: String::new() };
        let mut memory = Memory::default();
        if opened.file.exists() {
            let json = fs::read(&opened.file).with_context(|| format!("cannot read the memory in {name}"))?;
            let read = memory.read_json(&json, opened.weights.as_deref());
            read.with_context(|| format!("cannot use the memory in {name}"))?;
        }
        // A file that cannot be written is found before anything is learned.
        opened.save(&memory)?;
        Ok((opened, memory))
    }

    /// Writes the memory, if it has changed. The file that was there stays until the new one is complete, so that a
    /// program that is ended meanwhile loses one puzzle at most.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn save(&mut self, memory: &Memory) -> anyhow::Result<()> {
        let json = memory.to_json(self.weights.as_deref());
        if json == self.written {
            return Ok(());
        }
        let part = beside(&self.file, ".part");
        fs::write(&part, &json)
            .and_then(|()| fs::rename(&part, &self.file))
            .with_context(|| format!("cannot write the memory to {}", self.file.display()))?;
        self.written = json;
        Ok(())
    }
}

impl Drop for MemoryFile {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.lock_file);
    }
}

fn beside(file: &Path, ending: &str) -> PathBuf {
    let mut name: OsString = file.as_os_str().to_owned();
    name.push(ending);
    name.into()
}
