//! `plm-impact man`

use clap::{Args, Command};
use clap_mangen::Man;
use plm_impact::error::Error;

/// Print the manual page of the program, or of one command
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact man run > plm-impact-run.1
  plm-impact man | man -l -")]
pub struct Arguments {
    /// Command
    command: Option<String>,
}

pub fn man(Arguments { command }: &Arguments, mut program: Command) -> Result<(), Error> {
    program.build();
    let page = match command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| unknown(name, &program))?,
    };
    let mut text = Vec::new();
    Man::new(page).render(&mut text).map_err(super::terminal::other("manual page"))?;
    super::terminal::print(&String::from_utf8_lossy(&text))
}

fn unknown(name: &str, program: &Command) -> Error {
    let names: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
    super::names::unknown("command", "commands", name, &names)
}
