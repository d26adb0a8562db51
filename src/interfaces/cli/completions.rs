//! `plm-impact completions`

use clap::{Args, Command};
use clap_complete::{Shell, generate};
use plm_impact::error::Error;

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
