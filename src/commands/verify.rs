//! `pathlight verify`: simulates the attempts of a file again, and says for each whether it is the same to the bit.

use std::fs;
use std::io::{self, Read, Write};
use std::process::ExitCode;

use anyhow::Context;
use pathlight::verification::{AttemptLine, LineFault, Verdict};
use rayon::prelude::*;

use super::exit::is_broken_pipe;
use super::json_lines::{Numbered, parse};
use super::progress::say;

/// Simulate the attempts of a file again, and say for each whether it is the same to the bit, differs or is not valid
///
/// Each line is an attempt as the page exports it and `simulate --verifiable` writes it: {"task" or "scene", "ball",
/// "simulator", "status", "steps", "digest"}. The digest is a hash, in lowercase hexadecimal, of every pose of every
/// body after each step.
///
/// Prints {"line", "verdict", "reason"} for each line that is not blank. The verdict is "same" if all poses are the
/// same to the bit, "other_outcome" if status, steps or poses differ, or "not_valid" if the line cannot be simulated.
/// The exit code is 0 if all are the same, 2 if some are not valid, and 1 otherwise.
#[derive(clap::Args)]
pub struct Args {
    /// Attempts as JSON lines; "-" is standard input
    #[arg(value_name = "FILE")]
    file: String,
}

impl Args {
    pub fn run(self) -> anyhow::Result<ExitCode> {
        let mut bytes = Vec::new();
        match self.file.as_str() {
            "-" => io::stdin().lock().read_to_end(&mut bytes).map(drop),
            path => fs::read(path).map(|read| bytes = read),
        }
        .with_context(|| format!("cannot read {}", self.file))?;
        let lines: Vec<(usize, &[u8])> = (1..).zip(bytes.split(|&byte| byte == b'\n')).collect();
        let attempts: Vec<_> = lines.into_iter().filter(|(_, line)| !line.trim_ascii().is_empty()).collect();
        anyhow::ensure!(!attempts.is_empty(), "{} holds no attempts: export some on the page", self.file);
        let verdicts: Vec<(usize, Verdict)> =
            attempts.into_par_iter().map(|(number, line)| (number, verdict(line))).collect();
        let count = |matches: fn(&Verdict) -> bool| verdicts.iter().filter(|(_, verdict)| matches(verdict)).count();
        let same = count(|verdict| matches!(verdict, Verdict::Same));
        let other = count(|verdict| matches!(verdict, Verdict::OtherOutcome { .. }));
        let not_valid = count(|verdict| matches!(verdict, Verdict::NotValid { .. }));
        // A reader that needs no more lines, like `head`, still gets the code of all.
        print(&verdicts).or_else(|error| if is_broken_pipe(&error) { Ok(()) } else { Err(error) })?;
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

fn verdict(line: &[u8]) -> Verdict {
    match parse::<AttemptLine>(line, "`simulate --verifiable` writes attempts, and the page exports them") {
        Ok(attempt) => attempt.verify(),
        Err(reason) => Verdict::not_valid(LineFault::Form, format!("The line is not an attempt: {reason}.")),
    }
}
