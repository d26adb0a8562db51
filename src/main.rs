//! The command: it reads the command line, runs the command, prints an error, and chooses the exit code.

#[path = "interfaces/cli/mod.rs"]
mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    match cli::run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => ExitCode::from(cli::terminal::error(&error)),
    }
}
