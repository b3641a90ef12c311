//! A batch: one JSON request per line in, one answer per line out, in the same order, on all cores.
//!
//! Lines are processed in chunks, so that memory stays bounded. A chunk ends where the next line has not yet arrived,
//! so that a client that writes a line and waits gets its answer.

use std::fs;
use std::io::{self, BufWriter, Read, Write};
use std::path::Path;

use anyhow::Context;
use pathlight::command_line::progress::Progress;
use pathlight::puzzle::custom_scene::sentences;
use pathlight::puzzle::task::Task;
use pathlight::session::puzzle::Puzzle;
use pathlight::simulator::Engine;
use rayon::prelude::*;

use super::start::{Place, Request};
use super::{Answer, Format, attempt_line};
use crate::commands::input;
use crate::commands::json_lines::{Line, Lines, MAX_LINE, Numbered, Refusal, parse};

/// Lines per core in one chunk: enough that cores rarely wait for each other.
const LINES_PER_CORE: usize = 64;

const EXAMPLE: &str = r#"write a line like {"task":"00007:008","ball":[128,200,15]}"#;

/// Simulates the lines of a file, or of standard input if it is `-`.
pub fn run(file: &Path, format: Format, engine: Engine) -> anyhow::Result<()> {
    let mut lines = Lines::new(input::open(file)?, MAX_LINE);
    let bytes = fs::metadata(file).ok().filter(fs::Metadata::is_file).map(|about| about.len());
    let mut out = BufWriter::new(io::stdout().lock());
    let mut progress = Progress::new(bytes);
    let (mut answered, mut bad) = (0, 0);
    loop {
        let chunk = next_chunk(&mut lines).with_context(|| format!("cannot read {}", file.display()))?;
        if chunk.is_empty() {
            break;
        }
        let read: usize = chunk.iter().map(|line| line.text.as_ref().map_or(0, String::len)).sum();
        let chunk = chunk.into_par_iter().filter(|line| !line.is_blank());
        let answers: Vec<_> = chunk.map(|line| (line.number, answer(line, format, engine))).collect();
        for (line, answer) in answers {
            match answer {
                Ok(answer) => {
                    writeln!(out, "{answer}")?;
                    answered += 1;
                }
                Err(error) => {
                    progress.print(&format!("error: line {line}: {error:#}"));
                    let answer = Refusal::from(&error);
                    writeln!(out, "{}", serde_json::to_string(&Numbered { line, answer })?)?;
                    bad += 1;
                }
            }
        }
        out.flush()?;
        progress.advance(read as u64, format!("{answered} balls"));
    }
    progress.finish(&format!("{answered} balls"));
    match bad {
        0 => Ok(()),
        1 => anyhow::bail!("1 line could not be simulated; it is named above"),
        _ => anyhow::bail!("{bad} lines could not be simulated; they are named above"),
    }
}

/// Returns the next lines; none at the end. Waits for input only while it has no line.
fn next_chunk(lines: &mut Lines<impl Read>) -> io::Result<Vec<Line>> {
    let mut chunk = Vec::new();
    while chunk.len() < LINES_PER_CORE * rayon::current_num_threads()
        && (chunk.is_empty() || lines.has_arrived())
        && let Some(line) = lines.next()
    {
        chunk.push(line?);
    }
    Ok(chunk)
}

/// Returns the answer to a line.
fn answer(line: Line, format: Format, engine: Engine) -> anyhow::Result<String> {
    let Request { place, start } = parse(&line.text?, EXAMPLE)?;
    let puzzle = match place {
        Place::Task(task) => Puzzle::from(Task::load(task)?),
        Place::Scene(scene) => Puzzle::read(scene).map_err(|problems| anyhow::anyhow!("{}", sentences(&problems)))?,
    };
    let scene = &puzzle.scene;
    let ball = start.place(scene);
    let placed = ball.ok().flatten();
    let answer = match format {
        Format::Verifiable => return Ok(serde_json::to_string(&attempt_line(&puzzle, ball, engine))?),
        Format::Answer { paths: true } => {
            let rollout = ball.and_then(|ball| engine.simulate(scene, ball));
            Answer::of_rollout(&puzzle, start, placed, &rollout, engine, true)
        }
        // This format keeps no poses.
        Format::Answer { paths: false } => {
            let outcome = ball.and_then(|ball| engine.outcome(scene, ball));
            Answer::new(puzzle.id.task(), start, placed, engine, outcome)
        }
    };
    Ok(serde_json::to_string(&Numbered { line: line.number, answer })?)
}
