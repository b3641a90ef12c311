//! What a long piece of work tells whoever started it. The binary shows it on standard error.

/// Receives the progress of one piece of work after the other.
pub trait Progress {
    /// A piece of work of this many units begins.
    fn begin(&mut self, total: u64);

    /// Units of work were done; `so_far` describes what has come of all: "1200 rollouts".
    fn advance(&mut self, units: u64, so_far: String);

    /// The piece of work is done.
    fn finish(&mut self, result: &str);

    /// Something to know beside it.
    fn say(&mut self, line: &str);
}
