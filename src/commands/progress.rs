//! How far a long command is, on standard error: a bar on a terminal, else a line now and then.
//!
//! Used by the commands that run for long; never touches standard output.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Between two lines where there is no terminal.
const PAUSE: Duration = Duration::from_secs(10);

pub struct Progress {
    bar: ProgressBar,
    spoke: Instant,
}

impl Progress {
    /// `total` is in any unit, the one that `advance` is told in; `None` if nobody knows how much there will be.
    pub fn new(total: Option<u64>) -> Progress {
        let bar = match total {
            Some(total) => ProgressBar::new(total).with_style(style("{bar:40} {percent:>3} %  {msg}  {eta} left")),
            None => ProgressBar::no_length().with_style(style("{spinner} {msg}  {elapsed}")),
        };
        Progress { bar, spoke: Instant::now() }
    }

    /// `units` more are done; `so_far` says it in words: "1200 rollouts".
    pub fn advance(&mut self, units: u64, so_far: String) {
        self.bar.inc(units);
        if !self.bar.is_hidden() {
            self.bar.set_message(so_far);
        } else if self.spoke.elapsed() >= PAUSE {
            self.spoke = Instant::now();
            match self.bar.length() {
                Some(total) => eprintln!("{so_far}, {} %", 100 * self.bar.position() / total.max(1)),
                None => eprintln!("{so_far}"),
            }
        }
    }

    /// Prints a line above the bar.
    pub fn say(&self, line: &str) {
        self.bar.suspend(|| eprintln!("{line}"));
    }

    /// Takes the bar away and leaves one line behind: the result, and how long it took.
    pub fn finish(self, result: &str) {
        self.bar.finish_and_clear();
        eprintln!("{result} in {:.1} s", self.bar.elapsed().as_secs_f64());
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).expect("the templates above are well formed")
}
