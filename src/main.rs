//! The native binary: `pathlight COMMAND …`. See `commands`.
//!
//! In a wasm32 build, where there is no command line, `main` does nothing.

#[cfg(not(target_arch = "wasm32"))]
mod commands;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    commands::run()
}

#[cfg(target_arch = "wasm32")]
fn main() {}
