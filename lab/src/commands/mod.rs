//! The command line of the lab: a module for each group of commands.
//!
//! A command turns its arguments into the settings of a library function, calls it, and prints the result. The rules of
//! `pathlight` apply here too: results go to standard output, progress and messages to standard error, bad input is an
//! error with exit code 2, and a closed pipe ends a command quietly.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use pathlight::command_line::exit;
use pathlight_lab::progress::Progress;

mod data;
mod figures;
mod measure;
mod publish;
mod reproduce;
mod shared_args;
mod shown_progress;
mod train;

use shown_progress::ShownProgress;

/// The research behind Pathlight: data, training, measurements and figures.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Make training data, and measure how hard the tasks are
    #[command(subcommand)]
    Data(data::Command),
    /// Train nets on a fold
    #[command(subcommand)]
    Train(train::Command),
    /// Measure agents and nets on test tasks, and compare the simulator with PHYRE's
    #[command(subcommand)]
    Measure(measure::Command),
    Reproduce(reproduce::Args),
    Figures(figures::Args),
    /// Write the files that the page loads
    #[command(subcommand)]
    Publish(publish::Command),
}

/// Parses the arguments of the process and runs the command.
pub fn run() -> ExitCode {
    let result = CommandLine::parse().command.run(&mut ShownProgress::default());
    exit::code(result.map(|()| ExitCode::SUCCESS))
}

impl Command {
    fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        match self {
            Command::Data(command) => command.run(progress),
            Command::Train(command) => command.run(progress),
            Command::Measure(command) => command.run(progress),
            Command::Reproduce(args) => args.run(progress),
            Command::Figures(args) => args.run(),
            Command::Publish(command) => command.run(),
        }
    }
}

/// Prints the paths of written files. All files are written before any path is printed, so that a closed pipe stops
/// nothing halfway.
fn print_paths(paths: &[PathBuf]) -> anyhow::Result<()> {
    let mut out = io::stdout().lock();
    for path in paths {
        writeln!(out, "{}", path.display())?;
    }
    Ok(())
}
