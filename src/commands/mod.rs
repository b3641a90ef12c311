//! The command line, one module per command; used by `main` only.
//!
//! A command is an `Args` with a `run`. Its results go to standard output, its progress and messages to standard
//! error. Bad input is an error: one sentence after `error:`, exit code 2. If the reader of standard output closes
//! it (`pathlight tasks | head`), the command ends quietly with success; so commands write with `writeln!`, because
//! `println!` panics then.

use std::path::Path;
use std::process::ExitCode;
use std::{fs, io};

use anyhow::Context;
use clap::{Parser, Subcommand};
use pathlight::puzzle::task::TaskError;
use pathlight::puzzle::templates::{TEMPLATES, Template};
use sha2::{Digest, Sha256};

mod agent;
mod agent_name;
mod calibration;
mod collect;
mod differences;
mod difficulty;
mod dqn_args;
mod engine_arg;
mod evaluate;
mod fidelity;
mod figures;
mod file_lock;
mod fold_args;
mod forecasts;
mod journal;
mod json_file;
mod json_lines;
mod label;
mod labelled_scenes;
mod merge;
mod model_args;
mod own_scene_file;
mod progress;
mod propose;
mod publish;
mod publish_results;
mod replace_file;
mod reproduce;
mod shipped;
mod simulate;
mod solve_rates;
mod task_selection;
mod tasks;
mod train;
mod train_dqn;
mod train_dynamics;
mod train_judge;
mod training_args;
mod training_run;
mod verify;

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
    Train(train::Args),
    Label(label::Args),
    Merge(merge::Args),
    TrainJudge(train_judge::Args),
    TrainDynamics(train_dynamics::Args),
    TrainDqn(train_dqn::Args),
    Publish(publish::Args),
    PublishResults(publish_results::Args),
    Propose(propose::Args),
    Agent(agent::Args),
    Evaluate(evaluate::Args),
    Forecasts(forecasts::Args),
    Calibration(calibration::Args),
    Reproduce(reproduce::Args),
    Figures(figures::Args),
    Simulate(simulate::Args),
    Verify(verify::Args),
    Serve(pathlight_serve::Args),
    Fidelity(fidelity::Args),
    SolveRates(solve_rates::Args),
    Difficulty(difficulty::Args),
}

impl Command {
    fn run(self) -> anyhow::Result<ExitCode> {
        let done = match self {
            Command::Verify(args) => return args.run(),
            Command::Tasks(args) => args.run(),
            Command::Collect(args) => args.run(),
            Command::Train(args) => args.run(),
            Command::Label(args) => args.run(),
            Command::Merge(args) => args.run(),
            Command::TrainJudge(args) => args.run(),
            Command::TrainDynamics(args) => args.run(),
            Command::TrainDqn(args) => args.run(),
            Command::Publish(args) => args.run(),
            Command::PublishResults(args) => args.run(),
            Command::Propose(args) => args.run(),
            Command::Agent(args) => args.run(),
            Command::Evaluate(args) => args.run(),
            Command::Forecasts(args) => args.run(),
            Command::Calibration(args) => args.run(),
            Command::Reproduce(args) => args.run(),
            Command::Figures(args) => args.run(),
            Command::Simulate(args) => args.run(),
            Command::Serve(args) => args.run(),
            Command::Fidelity(args) => args.run(),
            Command::SolveRates(args) => args.run(),
            Command::Difficulty(args) => args.run(),
        };
        done.map(|()| ExitCode::SUCCESS)
    }
}

/// Runs the command that the process was started with.
pub fn run() -> ExitCode {
    let result = CommandLine::parse().command.run();
    match result {
        Ok(code) => code,
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            progress::say(&format!("error: {error:#}"));
            ExitCode::from(2)
        }
    }
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let kind = |cause: &(dyn std::error::Error + 'static)| match cause.downcast_ref::<serde_json::Error>() {
        Some(error) => error.io_error_kind(),
        None => cause.downcast_ref::<io::Error>().map(io::Error::kind),
    };
    error.chain().any(|cause| kind(cause) == Some(io::ErrorKind::BrokenPipe))
}

/// Returns the default arguments of a command, or of a group of its arguments.
fn defaults<A: clap::Args>() -> A {
    let command = A::augment_args(clap::Command::new("defaults").no_binary_name(true));
    let matches = command.get_matches_from(std::iter::empty::<&str>());
    A::from_arg_matches(&matches).expect("every argument is optional or has a default")
}

/// SHA-256 of a file, in hexadecimal.
fn digest(path: &Path) -> anyhow::Result<String> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Parses the number of a template, like `00007` or `7`.
fn template(text: &str) -> Result<&'static Template, TaskError> {
    let number = text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse::<usize>().ok()).flatten();
    let template = number.and_then(|number| TEMPLATES.get(number));
    template.copied().ok_or_else(|| TaskError::NoTemplate(text.to_string()))
}
