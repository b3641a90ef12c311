//! The command line, one module per command; used by `main` only.
//!
//! A command is an `Args` with a `run`. Results go to standard output, progress and messages to standard error. Bad
//! input is an error: one sentence after `error:`, exit code 2. If the reader closes standard output
//! (`pathlight tasks | head`), the command ends quietly with success. Commands therefore write with `writeln!`, because
//! `println!` would panic.

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use pathlight::command_line::exit;

mod agent;
mod custom_scene_file;
mod input;
mod json_lines;
mod propose;
mod simulate;
mod tasks;
mod verify;

/// Physics puzzles, and what small neural nets imagine for them.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Tasks(tasks::Args),
    Simulate(simulate::Args),
    Verify(verify::Args),
    Propose(propose::Args),
    Agent(agent::Args),
    Serve(pathlight_serve::Args),
}

impl Command {
    fn run(self) -> anyhow::Result<ExitCode> {
        let done = match self {
            Command::Verify(args) => return args.run(),
            Command::Tasks(args) => args.run(),
            Command::Simulate(args) => args.run(),
            Command::Propose(args) => args.run(),
            Command::Agent(args) => args.run(),
            Command::Serve(args) => args.run(),
        };
        done.map(|()| ExitCode::SUCCESS)
    }
}

/// Runs the command given by the process's arguments.
pub fn run() -> ExitCode {
    exit::code(CommandLine::parse().command.run())
}
