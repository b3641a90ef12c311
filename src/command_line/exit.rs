//! How a command ends; used by the lab's binary too.

use std::io;
use std::process::ExitCode;

use super::progress::say;

/// Prints the error of a command, if any, and returns its exit code.
pub fn code(result: anyhow::Result<ExitCode>) -> ExitCode {
    match result {
        Ok(code) => code,
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            say(&format!("error: {error:#}"));
            ExitCode::from(2)
        }
    }
}

/// Lets a command go on whose output nobody reads any more.
///
/// # Errors
///
/// Those of the command, except a broken pipe.
pub fn unless_broken_pipe(result: anyhow::Result<()>) -> anyhow::Result<()> {
    result.or_else(|error| if is_broken_pipe(&error) { Ok(()) } else { Err(error) })
}

/// Returns whether the reader of the output has stopped reading.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let kind = |cause: &(dyn std::error::Error + 'static)| match cause.downcast_ref::<serde_json::Error>() {
        Some(error) => error.io_error_kind(),
        None => cause.downcast_ref::<io::Error>().map(io::Error::kind),
    };
    error.chain().any(|cause| kind(cause) == Some(io::ErrorKind::BrokenPipe))
}
