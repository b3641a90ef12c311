//! `pathlight verify`: simulates the attempts in a file again, and reports for each whether it is the same to the bit.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Context;
use pathlight::command_line::exit::unless_broken_pipe;
use pathlight::command_line::progress::say;
use pathlight::verification::{AttemptLine, LineFault, Verdict};
use rayon::prelude::*;

use super::input;
use super::json_lines::{Line, Lines, MAX_LINE, Numbered, parse};

/// Simulate the attempts in a file again, and report for each whether it is the same to the bit, differs or is not
/// valid
///
/// Each line is an attempt as exported by the page or written by `simulate --verifiable`: {"task" or "scene", "ball",
/// "simulator", "status", "steps", "digest"}. The digest is a hash, in lowercase hexadecimal, of every pose of every
/// body after each step.
///
/// Prints {"line", "verdict", "reason"} for each line that is not blank. The verdict is "same" if all poses are the
/// same to the bit, "other_outcome" if status, steps or poses differ, or "not_valid" if the line cannot be simulated.
/// The exit code is 0 if all attempts are the same, 2 if some are not valid, and 1 otherwise.
#[derive(clap::Args)]
pub struct Args {
    /// Attempts as JSON lines; "-" is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
}

impl Args {
    pub fn run(self) -> anyhow::Result<ExitCode> {
        let name = self.file.display();
        let lines: Vec<Line> = Lines::new(input::open(&self.file)?, MAX_LINE)
            .collect::<io::Result<_>>()
            .with_context(|| format!("cannot read {name}"))?;
        let attempts: Vec<Line> = lines.into_iter().filter(|line| !line.is_blank()).collect();
        anyhow::ensure!(!attempts.is_empty(), "{name} contains no attempts: export some on the page");
        let verdicts: Vec<(usize, Verdict)> =
            attempts.into_par_iter().map(|line| (line.number, verdict(line.text))).collect();
        let count = |matches: fn(&Verdict) -> bool| verdicts.iter().filter(|(_, verdict)| matches(verdict)).count();
        let same = count(|verdict| matches!(verdict, Verdict::Same));
        let other = count(|verdict| matches!(verdict, Verdict::OtherOutcome { .. }));
        let not_valid = count(|verdict| matches!(verdict, Verdict::NotValid { .. }));
        // If a reader like `head` stops early, the exit code is still that of all attempts.
        unless_broken_pipe(print(&verdicts))?;
        say(&format!("{same} the same to the bit, {other} with another outcome, {not_valid} not valid"));
        Ok(ExitCode::from(if not_valid > 0 { 2 } else { u8::from(other > 0) }))
    }
}

fn print(verdicts: &[(usize, Verdict)]) -> anyhow::Result<()> {
    let mut out = io::stdout().lock();
    for (line, verdict) in verdicts {
        serde_json::to_writer(&mut out, &Numbered { line: *line, answer: verdict })?;
        writeln!(out)?;
    }
    Ok(())
}

fn verdict(text: anyhow::Result<String>) -> Verdict {
    let remedy = "`simulate --verifiable` writes attempts, and the page exports them";
    match text.and_then(|text| parse::<AttemptLine>(&text, remedy)) {
        Ok(attempt) => attempt.verify(),
        Err(reason) => Verdict::not_valid(LineFault::Form, format!("The line is not an attempt: {reason}.")),
    }
}
