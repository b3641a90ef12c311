//! Progress of a long command on standard error: a bar on a terminal, otherwise a line from time to time.
//!
//! The lab's binary uses it too. Never writes to standard output. A closed standard error does not stop the work.

use std::io::{self, Write};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Time between two lines when standard error is not a terminal.
const PAUSE: Duration = Duration::from_secs(10);

/// Prints a line on standard error.
pub fn say(line: &str) {
    // `eprintln!` panics if the reader is gone.
    let _ = writeln!(io::stderr(), "{line}");
}

pub struct Progress {
    bar: ProgressBar,
    last_line: Instant,
}

impl Progress {
    /// `total` is in the unit of `advance`; `None` if unknown.
    pub fn new(total: Option<u64>) -> Progress {
        let bar = match total {
            Some(total) => ProgressBar::new(total).with_style(style("{bar:40} {percent:>3} %  {msg}  {eta} left")),
            None => ProgressBar::no_length().with_style(style("{spinner} {msg}  {elapsed}")),
        };
        Progress { bar, last_line: Instant::now() }
    }

    /// Adds units of completed work; `so_far` describes the progress: "1200 rollouts".
    pub fn advance(&mut self, units: u64, so_far: String) {
        self.bar.inc(units);
        if !self.bar.is_hidden() {
            self.bar.set_message(so_far);
        } else if self.last_line.elapsed() >= PAUSE {
            self.last_line = Instant::now();
            match self.bar.length() {
                Some(total) => say(&format!("{so_far}, {} %", 100 * self.bar.position() / total.max(1))),
                None => say(&so_far),
            }
        }
    }

    /// Prints a line above the bar.
    pub fn print(&self, line: &str) {
        self.bar.suspend(|| say(line));
    }

    /// Removes the bar and prints one line: the result and the elapsed time.
    pub fn finish(self, result: &str) {
        self.bar.finish_and_clear();
        say(&format!("{result} in {:.1} s", self.bar.elapsed().as_secs_f64()));
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).expect("the templates are well formed")
}
