//! The command: parse, call, print what went wrong, choose the exit code.

mod cli;

use std::process::ExitCode;

use plm_impact::error::Error;

fn main() -> ExitCode {
    match cli::run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            cli::terminal::note(format_args!("error: {error:#}"));
            ExitCode::from(error.downcast_ref::<Error>().map_or(1, Error::exit_code))
        }
    }
}
