//! `pathlight-serve`: `pathlight serve` as a separate binary, which `make play` can build faster.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

/// Serve the Pathlight page to a browser on this machine
#[derive(Parser)]
#[command(version)]
struct CommandLine {
    #[command(flatten)]
    args: pathlight_serve::Args,
}

fn main() -> ExitCode {
    match CommandLine::parse().args.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // `eprintln!` panics if the reader is gone.
            let _ = writeln!(io::stderr(), "error: {error:#}");
            ExitCode::from(2)
        }
    }
}
