//! A measurement as JSON in a file, beside the table that is printed.

use std::io::{self, Write};
use std::path::Path;

use pathlight_lab::files::json_file;
use serde::Serialize;

/// Writes the file, if one is named, and returns the table to print. The file comes first, so that a closed pipe does
/// not lose it.
///
/// # Errors
/// If it cannot be written; then the table has been printed, so that the measurement is not lost.
pub fn write(path: Option<&Path>, value: &impl Serialize, table: String) -> anyhow::Result<String> {
    let written = json_file::write(path, value);
    if written.is_err() {
        // The error that is told is that of the file.
        let _ = writeln!(io::stdout(), "{table}");
    }
    written.map(|()| table)
}
