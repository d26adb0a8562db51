//! `plm-impact completions` and `plm-impact man`

use clap::{Args, Command};
use clap_complete::{Shell, generate};
use clap_mangen::Man;
use plm_impact::error::Error;
use plm_impact::units::did_you_mean;

/// Print the completions of a shell
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact completions bash > ~/.local/share/bash-completion/completions/plm-impact
  plm-impact completions zsh > _plm-impact")]
pub struct Completions {
    /// The shell
    shell: Shell,
}

pub fn completions(Completions { shell }: &Completions, mut program: Command) -> Result<(), Error> {
    let mut text = Vec::new();
    generate(*shell, &mut program, env!("CARGO_PKG_NAME"), &mut text);
    // for bash a program with a hyphen in its name has two names, until https://github.com/clap-rs/clap/issues/6421 is solved
    let [wrong, right] = ["__subcmd__", "__"].map(|hyphen| env!("CARGO_PKG_NAME").replace('-', hyphen));
    super::terminal::print(&String::from_utf8_lossy(&text).replace(&wrong, &right))
}

/// Print the manual page of the program, or of one command
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact man run > plm-impact-run.1
  plm-impact man | man -l -")]
pub struct Manual {
    /// Command
    command: Option<String>,
}

pub fn man(Manual { command }: &Manual, mut program: Command) -> Result<(), Error> {
    program.build();
    let page = match command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| {
            let names: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
            let known = format!("commands are {}", names.join(", "));
            Error::input(format!("unknown command \"{name}\"{}", did_you_mean(name, names, '"', &known)))
        })?,
    };
    let mut text = Vec::new();
    Man::new(page).render(&mut text).map_err(super::terminal::other("manual page"))?;
    super::terminal::print(&String::from_utf8_lossy(&text))
}
