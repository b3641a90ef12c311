//! Progress reports of long work. The binary shows them on standard error.

/// Receives the progress of pieces of work, one at a time.
pub trait Progress {
    /// Begins a piece of work of `total` units.
    fn begin(&mut self, total: u64);

    /// Records finished units of work; `so_far` describes the result so far: "1200 rollouts".
    fn advance(&mut self, units: u64, so_far: String);

    /// Ends the piece of work.
    fn finish(&mut self, result: &str);

    /// Reports a message.
    fn say(&mut self, line: &str);
}
