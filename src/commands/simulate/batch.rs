//! A batch: one JSON request per line in, one answer per line out, in the same order, on all cores.
//!
//! Works through the lines in chunks and limits their length, so that memory stays bounded. The first answers come
//! at once, also to a program that writes a few lines and waits.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};

use anyhow::{Context, ensure};
use pathlight::puzzle::own_scene::sentences;
use pathlight::puzzle::task::Task;
use pathlight::session::played::Played;
use pathlight::simulator::Engine;
use rayon::prelude::*;

use super::start::{Place, Request};
use super::{Answer, Format, attempt_line};
use crate::commands::progress::Progress;

/// Lines per core in one chunk: enough that cores rarely wait for one another.
const LINES_PER_CORE: usize = 64;

/// Longest line, bytes. The largest scene needs some 10,000, a task about 50; other keys may take the rest.
const MAX_LINE: usize = 1 << 16;

const EXAMPLE: &str = r#"{"task":"00007:008","ball":[128,200,15]}"#;

/// Simulates the lines of a file, or of standard input if it is `-`.
pub fn run(file: &str, format: Format, engine: Engine) -> anyhow::Result<()> {
    let (source, bytes): (Box<dyn Read>, _) = match file {
        "-" => (Box::new(io::stdin().lock()), None),
        path => {
            let file = File::open(path).with_context(|| format!("cannot read {path}"))?;
            let about = file.metadata()?;
            (Box::new(file), about.is_file().then_some(about.len()))
        }
    };
    let mut source = BufReader::with_capacity(1 << 16, source);
    let mut out = BufWriter::new(io::stdout().lock());
    let mut progress = Progress::new(bytes);
    let (mut first, mut answered, mut bad) = (1, 0, 0);
    loop {
        let mut lines = next_lines(&mut source).with_context(|| format!("cannot read {file}"))?;
        if lines.is_empty() {
            break;
        }
        let too_long = lines.pop_if(|line| line.len() > MAX_LINE).is_some();
        let answers: Vec<_> = lines.par_iter().map(|line| answer(line, format, engine)).collect();
        for (number, answer) in (first..).zip(answers) {
            match answer {
                Ok(Some(answer)) => {
                    writeln!(out, "{answer}")?;
                    answered += 1;
                }
                Ok(None) => {}
                Err(error) => {
                    progress.print(&format!("error: line {number}: {error}"));
                    bad += 1;
                }
            }
        }
        out.flush()?;
        first += lines.len();
        ensure!(
            !too_long,
            "line {first} of {file} is longer than {MAX_LINE} bytes, so the rest was not read: write one request per \
             line"
        );
        progress.advance(lines.iter().map(|line| line.len() as u64).sum(), format!("{answered} balls"));
    }
    progress.finish(&format!("{answered} balls"));
    match bad {
        0 => Ok(()),
        1 => anyhow::bail!("1 line could not be simulated; it is named above"),
        _ => anyhow::bail!("{bad} lines could not be simulated; they are named above"),
    }
}

/// The next chunk of lines, line breaks included; empty at the end. Waits for input only while it has no line. A line
/// that is too long ends the chunk, cut off.
fn next_lines(source: &mut BufReader<impl Read>) -> io::Result<Vec<Vec<u8>>> {
    let mut lines = Vec::new();
    while lines.len() < LINES_PER_CORE * rayon::current_num_threads() {
        let mut line = Vec::new();
        if source.take(MAX_LINE as u64 + 1).read_until(b'\n', &mut line)? == 0 {
            break;
        }
        let too_long = line.len() > MAX_LINE;
        lines.push(line);
        if too_long || source.buffer().is_empty() {
            break;
        }
    }
    Ok(lines)
}

/// The answer to a line, nothing to a blank one, or what is wrong with it.
fn answer(line: &[u8], format: Format, engine: Engine) -> anyhow::Result<Option<String>> {
    if line.trim_ascii().is_empty() {
        return Ok(None);
    }
    let Request { place, start } = serde_json::from_slice(line).map_err(|error| {
        // The parser sees a single line and calls it line 1.
        let what = error.to_string().replace(" at line 1 column", " at column");
        anyhow::anyhow!("{what}; write it like {EXAMPLE}")
    })?;
    let played = match place {
        Place::Task(task) => Played::from(Task::load(task)?),
        Place::Scene(scene) => Played::read(scene).map_err(|problems| anyhow::anyhow!("{}", sentences(&problems)))?,
    };
    let scene = &played.scene;
    let ball = start.place(scene);
    let placed = ball.ok().flatten();
    let answer = match format {
        Format::Verifiable => serde_json::to_string(&attempt_line(&played, ball, engine)),
        Format::Answer { paths: true } => {
            let rollout = ball.and_then(|ball| engine.simulate(scene, ball));
            serde_json::to_string(&Answer::of_rollout(&played, placed, &rollout, engine, true))
        }
        // Keeps no poses.
        Format::Answer { paths: false } => {
            let outcome = ball.and_then(|ball| engine.outcome(scene, ball));
            serde_json::to_string(&Answer::new(played.id.task(), placed, engine, outcome))
        }
    };
    Ok(Some(answer?))
}
