//! The file that stores what puzzles with "remember" teach. Only one process at a time can use it.

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use pathlight::agents::memory::Memory;

use pathlight::command_line::replace_file::{check_replaceable, replace_file, without_links};

pub struct MemoryFile {
    file: PathBuf,
    /// The lock on a separate file next to it, because the file itself is replaced. The lock file is never deleted,
    /// since another process may be opening it.
    _lock: File,
    /// SHA-256 of the weights that the memory was learned with.
    weights: Option<String>,
    /// The current content of the file.
    written: String,
}

impl MemoryFile {
    /// Opens the file and reads the memory in it. The memory is empty if the file does not exist yet.
    ///
    /// # Errors
    ///
    /// If another process is using the file, if it cannot be read or written, or if it does not hold a memory of these
    /// weights.
    pub fn open(path: &Path, weights: Option<String>) -> anyhow::Result<(MemoryFile, Memory)> {
        let name = path.display();
        check_replaceable(path)?;
        // All links that lead to the file share one lock.
        let file = without_links(path)?;
        let lock = lock_file(&file);
        let lock = File::create(&lock).with_context(|| format!("cannot write {}", lock.display()))?;
        if let Err(TryLockError::WouldBlock) = lock.try_lock() {
            bail!("another process is using the memory in {name}: wait until it ends, or name another file");
        }
        let mut opened = MemoryFile { file, _lock: lock, weights, written: String::new() };
        let mut memory = Memory::default();
        if opened.file.exists() {
            let json = fs::read(&opened.file).with_context(|| format!("cannot read the memory in {name}"))?;
            let read = memory.read_json(&json, opened.weights.as_deref());
            read.with_context(|| format!("cannot use the memory in {name}"))?;
        }
        opened.save(&memory)?;
        Ok((opened, memory))
    }

    /// Writes the memory, if it has changed. The old file stays until the new one is complete, so a program that is
    /// killed in the meantime loses at most one puzzle.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn save(&mut self, memory: &Memory) -> anyhow::Result<()> {
        let json = memory.to_json(self.weights.as_deref());
        if json == self.written {
            return Ok(());
        }
        replace_file(&self.file, json.as_bytes())?;
        self.written = json;
        Ok(())
    }
}

fn lock_file(file: &Path) -> PathBuf {
    let mut name: OsString = file.as_os_str().to_owned();
    name.push(".lock");
    name.into()
}
