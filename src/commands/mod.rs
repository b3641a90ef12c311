//! The command line, one module for each command; used by `main` alone.
//!
//! A command is an `Args` with a `run`. What it prints for programs goes to standard output, what it says to
//! people while it works goes to standard error. Bad input is an error: one sentence after `error:`, exit code 2.

use std::path::Path;
use std::process::ExitCode;
use std::{fs, io};

use anyhow::Context;
use clap::{Parser, Subcommand};
use pathlight::puzzle::task::TaskError;
use pathlight::puzzle::templates::{TEMPLATES, Template};
use sha2::{Digest, Sha256};

mod collect;
mod differences;
mod evaluate;
mod fidelity;
mod file_lock;
mod fold_args;
mod journal;
mod label;
mod model_args;
mod progress;
mod propose;
mod publish;
mod scene_cache;
mod serve;
mod simulate;
mod solve_rates;
mod table;
mod task_selection;
mod tasks;
mod train;
mod train_judge;
mod training_args;
mod training_run;

/// Physics puzzles, and the paths that four small nets imagine for them.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Tasks(tasks::Args),
    Collect(collect::Args),
    Label(label::Args),
    TrainJudge(train_judge::Args),
    Train(train::Args),
    Publish(publish::Args),
    Propose(propose::Args),
    Evaluate(evaluate::Args),
    Table(table::Args),
    Simulate(simulate::Args),
    Serve(serve::Args),
    Fidelity(fidelity::Args),
    SolveRates(solve_rates::Args),
}

impl Command {
    fn run(self) -> anyhow::Result<()> {
        match self {
            Command::Tasks(args) => args.run(),
            Command::Collect(args) => args.run(),
            Command::Label(args) => args.run(),
            Command::TrainJudge(args) => args.run(),
            Command::Train(args) => args.run(),
            Command::Publish(args) => args.run(),
            Command::Propose(args) => args.run(),
            Command::Evaluate(args) => args.run(),
            Command::Table(args) => args.run(),
            Command::Simulate(args) => args.run(),
            Command::Serve(args) => args.run(),
            Command::Fidelity(args) => args.run(),
            Command::SolveRates(args) => args.run(),
        }
    }
}

/// Runs another command in this process, as if these words had been typed after `pathlight`; says so.
fn run_words(words: &[String]) -> anyhow::Result<()> {
    eprintln!("$ pathlight {}", words.join(" "));
    CommandLine::try_parse_from([&["pathlight".to_string()], words].concat())?.command.run()
}

/// Runs the command that the process was started with.
pub fn run() -> ExitCode {
    let result = CommandLine::parse().command.run();
    match result {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever read the output has enough of it: `pathlight tasks | head`.
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.downcast_ref::<io::Error>().is_some_and(|error| error.kind() == io::ErrorKind::BrokenPipe)
}

/// SHA-256 of a file, in hexadecimal digits.
fn digest(path: &Path) -> anyhow::Result<String> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect())
}

/// The template of a number like `00007` or `7`.
fn template(text: &str) -> Result<&'static Template, TaskError> {
    let number = text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse::<usize>().ok()).flatten();
    let template = number.and_then(|number| TEMPLATES.get(number));
    template.copied().ok_or_else(|| TaskError::NoTemplate(text.to_string()))
}
