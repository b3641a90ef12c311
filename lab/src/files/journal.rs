//! Append-only files of JSON lines that can be continued after an interruption; used by `data collect` and `data
//! label`.
//!
//! The first line holds the settings, and a file is continued only with the same settings. Every other line is an
//! entry. A killed process may leave an incomplete last line: readers skip it, and it is removed when the file is
//! continued. Any other unreadable line is an error, so that nobody trains on part of a file without noticing.

use std::fmt::Display;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{TaskId, ids};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::puzzle::utf8::utf8;
use serde::Serialize;
use serde::de::DeserializeOwned;

use super::differences::differences;
use super::file_lock::lock;
use crate::progress::Progress;

/// Maximum length of a line, bytes. Lines of `label` have about 8,000.
const MAX_LINE: u64 = 1 << 20;

/// A line after the first.
pub trait Entry: Serialize + DeserializeOwned {
    /// Type of the first line.
    type Settings: Serialize + DeserializeOwned;

    /// The command of the lab that writes these files.
    const COMMAND: &'static str;

    /// Checks conditions that parsing does not ensure.
    ///
    /// # Errors
    /// If a condition does not hold; the error names it.
    fn check(&self) -> Result<(), String>;
}

/// A file that only this process appends to.
pub struct Journal {
    path: PathBuf,
    file: File,
}

impl Journal {
    /// Opens a file for appending, and returns its entries. A new file begins with the settings. While another process
    /// has the file open, this one waits.
    ///
    /// # Errors
    /// If the file has other settings, is damaged, or cannot be written.
    pub fn open<E: Entry>(
        path: &Path,
        settings: &E::Settings,
        progress: &mut dyn Progress,
    ) -> anyhow::Result<(Journal, Vec<E>)> {
        let name = path.display();
        let mut journal = Journal { path: path.to_path_buf(), file: lock(path, progress)? };
        if is_cut_off_in_the_settings(&journal.file, &serde_json::to_vec(settings)?)? {
            journal.file.set_len(0).and_then(|()| journal.file.rewind()).with_context(|| journal.cannot_write())?;
            journal.append(std::slice::from_ref(settings))?;
            return Ok((journal, Vec::new()));
        }
        let contents = parse::<E>(&journal.file, path)?;
        let other = differences(&contents.settings, settings);
        ensure!(other.is_empty(), "{name} has other settings ({other}): choose another file, or remove this one");
        let file = &mut journal.file;
        file.set_len(contents.end)
            .and_then(|()| file.seek(SeekFrom::End(0)))
            .with_context(|| journal.cannot_write())?;
        if !contents.ends_with_newline {
            journal.write(b"\n")?;
        }
        Ok((journal, contents.entries))
    }

    /// Appends lines in one write.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn append(&mut self, lines: &[impl Serialize]) -> anyhow::Result<()> {
        let mut bytes = Vec::new();
        for line in lines {
            serde_json::to_writer(&mut bytes, line)?;
            bytes.push(b'\n');
        }
        self.write(&bytes)
    }

    fn write(&mut self, bytes: &[u8]) -> anyhow::Result<()> {
        self.file.write_all(bytes).with_context(|| self.cannot_write())
    }

    fn cannot_write(&self) -> String {
        format!("cannot write {}", self.path.display())
    }
}

/// Reads the settings and the entries of a file.
///
/// # Errors
/// If the file cannot be read, has a damaged line, or was not written by the command of the entries.
pub fn read<E: Entry>(path: &Path) -> anyhow::Result<(E::Settings, Vec<E>)> {
    let file = File::open(path)
        .with_context(|| format!("cannot read {}: run `pathlight-lab {}` first", path.display(), E::COMMAND))?;
    let contents = parse(&file, path)?;
    Ok((contents.settings, contents.entries))
}

/// Whether the file is empty or ends within the settings that this process would write. Such a file holds nothing to
/// lose, and no other file looks like it.
fn is_cut_off_in_the_settings(mut file: &File, settings: &[u8]) -> anyhow::Result<bool> {
    let mut start = Vec::new();
    file.take(settings.len() as u64).read_to_end(&mut start)?;
    file.rewind()?;
    Ok(start.len() < settings.len() && settings.starts_with(&start))
}

/// The content of a file.
pub struct Contents<E: Entry> {
    pub settings: E::Settings,
    pub entries: Vec<E>,
    /// Offset of the end of the last line that was read, bytes.
    end: u64,
    /// Whether the last line read ends with a newline.
    ends_with_newline: bool,
}

/// Parses a file. Errors name `path`.
///
/// # Errors
/// Same as for `read`.
pub fn parse<E: Entry>(file: impl Read, path: &Path) -> anyhow::Result<Contents<E>> {
    let (name, command) = (path.display(), E::COMMAND);
    let cannot_read = || format!("cannot read {name}");
    let mut reader = BufReader::new(file);
    let mut line = Vec::new();
    let mut next = |number: usize, line: &mut Vec<u8>| {
        line.clear();
        let length = (&mut reader).take(MAX_LINE).read_until(b'\n', line).with_context(cannot_read)? as u64;
        let is_complete = length < MAX_LINE || line.ends_with(b"\n");
        ensure!(
            is_complete,
            "line {number} of {name} has more than {MAX_LINE} bytes: choose a file of `pathlight-lab {command}`"
        );
        anyhow::Ok(length)
    };
    let length = next(1, &mut line)?;
    let settings = serde_json::from_str(utf8(&line).with_context(cannot_read)?);
    let settings =
        settings.with_context(|| format!("{name} is not a file of `pathlight-lab {command}`: choose another file"))?;
    let ends_with_newline = line.ends_with(b"\n");
    let mut contents = Contents { settings, entries: Vec::new(), end: length, ends_with_newline };
    for number in 2.. {
        let length = next(number, &mut line)?;
        if length == 0 {
            break;
        }
        let ends_with_newline = line.ends_with(b"\n");
        let entry = match serde_json::from_slice::<E>(&line) {
            Ok(entry) => entry,
            Err(_) if !ends_with_newline => break,
            Err(error) => bail!("line {number} of {name} is damaged ({error}): restore the file or make it again"),
        };
        if let Err(why) = entry.check() {
            bail!("line {number} of {name} is invalid ({why}): restore the file or make it again");
        }
        contents.entries.push(entry);
        contents.end += length;
        contents.ends_with_newline = ends_with_newline;
    }
    Ok(contents)
}

/// Checks that the benchmark has a task; for `Entry::check`.
///
/// # Errors
/// If the benchmark has no such task; the error names it.
pub fn check_task(task: TaskId) -> Result<(), String> {
    let known = TEMPLATES.get(task.template).is_some_and(|template| ids(template).any(|id| id == task));
    if known { Ok(()) } else { Err(format!("the benchmark has no task {task}")) }
}

/// Checks that a ball has a radius that the benchmark allows and is inside the scene; for `Entry::check`.
///
/// # Errors
/// If the ball does not fit; the error names the ball and the scene.
pub fn check_ball(scene: &impl Display, ball: &Ball) -> Result<(), String> {
    let fault = |_| format!("the ball {ball} of {scene} has a wrong radius or is not inside the scene");
    ball.check_bounds().map_err(fault)
}
