//! `plm-impact init`

use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::scenario::TEMPLATES;

use super::output::parse_choice;
use super::scenario::{STANDARD_INPUT, write_new_scenario};

/// Write a commented scenario template
///
/// The template can be run without changes. Existing files are never overwritten.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact init leeb
  plm-impact init --out - | plm-impact run - --json")]
pub struct InitArguments {
    /// Kind of the scenario
    #[arg(value_name = "KIND", default_value = "impact", value_parser = parse_choice(TEMPLATES, |(name, _)| name))]
    template: (&'static str, &'static str),
    /// File to write; - is standard output [default: KIND.toml]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

pub fn init(InitArguments { template: (name, text), out }: &InitArguments) -> Result<(), Error> {
    let out = out.clone().unwrap_or_else(|| format!("{name}.toml").into());
    if out == Path::new(STANDARD_INPUT) {
        return super::terminal::print(text);
    }
    write_new_scenario(&out, text, "--out")
}
