//! JSON lines in and JSON lines out: the protocol of `simulate --batch` and `agent`; `verify` reads the same lines.
//!
//! Each line that is not blank gets exactly one answer, in order. An answer has the number of its line. The answer to a
//! line that cannot be used is `{"line":N,"error":"…"}`. A client that writes a line and waits for the answer therefore
//! always gets one.

use std::io::{self, BufRead, BufReader, Read};

use anyhow::anyhow;
use pathlight::puzzle::utf8::{NotUtf8, utf8};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Bytes to read at once: some hundred lines, so that a batch keeps all cores busy.
const BUFFER: usize = 1 << 20;

/// Longest line that plays a ball, bytes. The largest scene needs about 10,000, a task about 50; the rest is for other
/// keys.
pub const MAX_LINE: usize = 1 << 16;

/// A line, and its number from 1.
pub struct Line {
    pub number: usize,
    /// The text, or the reason why the line cannot be used.
    pub text: anyhow::Result<String>,
}

impl Line {
    pub fn is_blank(&self) -> bool {
        self.text.as_ref().is_ok_and(|text| text.trim_ascii().is_empty())
    }
}

/// The lines of a source. A line that is too long is skipped without being stored, so memory stays bounded.
pub struct Lines<R> {
    source: BufReader<R>,
    /// Maximum number of bytes in a line.
    longest: usize,
    /// Lines read so far.
    count: usize,
}

impl<R: Read> Lines<R> {
    pub fn new(source: R, longest: usize) -> Lines<R> {
        Lines { source: BufReader::with_capacity(BUFFER, source), longest, count: 0 }
    }

    /// Returns whether the next line has already arrived, so that reading it does not block.
    pub fn has_arrived(&self) -> bool {
        self.source.buffer().contains(&b'\n')
    }
}

impl<R: Read> Iterator for Lines<R> {
    type Item = io::Result<Line>;

    /// Returns the next line, or an error if the source cannot be read or is UTF-16.
    fn next(&mut self) -> Option<io::Result<Line>> {
        let mut bytes = Vec::new();
        let read = self.source.by_ref().take(self.longest as u64 + 1).read_until(b'\n', &mut bytes);
        self.count += 1;
        let text = match read {
            Ok(0) => return None,
            Ok(read) if read > self.longest && !bytes.ends_with(b"\n") => self
                .source
                .skip_until(b'\n')
                .map(|_| Err(anyhow!("the line is longer than {} bytes: write one request per line", self.longest))),
            Ok(_) => match utf8(&bytes) {
                // If the source is UTF-16, no line can be read.
                Err(why @ NotUtf8::Utf16) if self.count == 1 => Err(io::Error::new(io::ErrorKind::InvalidData, why)),
                text => Ok(text.map(str::to_string).map_err(anyhow::Error::from)),
            },
            Err(error) => Err(error),
        };
        Some(text.map(|text| Line { number: self.count, text }))
    }
}

/// Parses a line as JSON.
///
/// # Errors
///
/// If the line does not parse; the error names the fault and then the remedy.
pub fn parse<T: DeserializeOwned>(line: &str, remedy: &str) -> anyhow::Result<T> {
    serde_json::from_str(line).map_err(|error| {
        // The parser sees a single line and calls it line 1.
        anyhow!("{}; {remedy}", error.to_string().replace(" at line 1 column", " at column"))
    })
}

/// An answer with the number of its line.
#[derive(Serialize)]
pub struct Numbered<A> {
    pub line: usize,
    #[serde(flatten)]
    pub answer: A,
}

/// The answer to a line that cannot be used.
#[derive(Serialize)]
pub struct Refusal {
    error: String,
}

impl From<&anyhow::Error> for Refusal {
    fn from(error: &anyhow::Error) -> Refusal {
        Refusal { error: format!("{error:#}") }
    }
}
