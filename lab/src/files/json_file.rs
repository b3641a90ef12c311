//! The JSON files that commands write with `--json`.

use std::fs;
use std::path::Path;

use anyhow::Context;
use pathlight::puzzle::utf8::utf8;
use serde::{Deserialize, Serialize};

use pathlight::command_line::replace_file::{check_replaceable, replace_file};

/// Reads a file. `command` is the command that writes it.
///
/// # Errors
/// If it is missing, damaged, or was written by another command.
pub fn read<T: for<'a> Deserialize<'a>>(path: &Path, command: &str) -> anyhow::Result<T> {
    let name = path.display();
    let bytes = fs::read(path).with_context(|| format!("cannot read {name}: write it with `{command}`"))?;
    let text = utf8(&bytes).with_context(|| format!("cannot read {name}"))?;
    serde_json::from_str(text)
        .with_context(|| format!("{name} is damaged, or another command wrote it: write it again with `{command}`"))
}

/// Checks that the file, if one is named, can be written, before a measurement that would otherwise be lost.
///
/// # Errors
/// If the file cannot be written.
pub fn check(path: Option<&Path>) -> anyhow::Result<()> {
    path.map_or(Ok(()), check_replaceable)
}

/// Writes the file, if one is named, and creates its folder if that is missing.
///
/// # Errors
/// If the file cannot be written. It is then unchanged.
pub fn write(path: Option<&Path>, value: &impl Serialize) -> anyhow::Result<()> {
    path.map_or(Ok(()), |path| replace_file(path, &serde_json::to_vec(value)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_order_mark_is_skipped_and_utf16_is_named() {
        let file = tempfile::NamedTempFile::new().expect("a file");
        let read = |bytes: &[u8]| {
            fs::write(&file, bytes).expect("written");
            read::<Vec<u8>>(file.path(), "a command")
        };
        assert_eq!(read("\u{feff}[1]".as_bytes()).expect("a list"), [1]);
        let refused = read(b"\xff\xfe[\x001\0]\0").expect_err("UTF-16");
        assert!(format!("{refused:#}").ends_with("this is UTF-16: save it as UTF-8"), "{refused:#}");
    }
}
