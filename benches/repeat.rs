//! The protocol between a Rust implementation and `bench.mjs`.

use std::io::{self, Write};
use std::time::{Duration, Instant};

/// Prints the result to compare, as JSON. Then reads numbers of repetitions from standard input, one per line, and
/// times each repetition. `work` returns its own duration.
pub fn repeat(result: &str, mut work: impl FnMut() -> Duration) {
    let mut output = io::stdout().lock();
    let mut say = |line: &str| writeln!(output, "{line}").and_then(|()| output.flush()).expect("bench.mjs reads this");
    say(result);
    for line in io::stdin().lines() {
        let repetitions = line.expect("text").parse().expect("a number of repetitions");
        let times: Vec<f64> = (0..repetitions).map(|_| work().as_secs_f64() * 1e3).collect();
        say(&format!("{times:?}"));
    }
}

/// Returns how long `work` takes.
pub fn stopwatch<T>(work: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    std::hint::black_box(work());
    start.elapsed()
}
