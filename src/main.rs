//! The native binary: `pathlight COMMAND …`. All it holds is the way in and the way out; see `commands`.
//!
//! In a wasm32 build, which has no command line, it is an empty program.

#[cfg(not(target_arch = "wasm32"))]
mod commands;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    commands::run()
}

#[cfg(target_arch = "wasm32")]
fn main() {}
