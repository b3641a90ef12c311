//! The binary of the lab: `pathlight-lab COMMAND …`. See `commands`.

mod commands;

fn main() -> std::process::ExitCode {
    commands::run()
}
