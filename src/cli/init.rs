//! `plm-impact init`

use std::fs::File;
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::scenario::{Kind, template};

use super::output::one_of;
use super::scenario::STANDARD_INPUT;
use super::terminal::other;

/// Write a scenario to begin with, in which a comment explains every key
///
/// It runs as it is. A file that is there is never overwritten.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact init sweep
  plm-impact init --out - | plm-impact run - --json")]
pub struct Arguments {
    /// What is to be run
    #[arg(default_value = "impact", value_parser = one_of(Kind::ALL, Kind::name))]
    kind: Kind,
    /// File to write; - is standard output [default: KIND.toml]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

pub fn init(Arguments { kind, out }: &Arguments) -> Result<(), Error> {
    let text = template(*kind);
    let out = out.clone().unwrap_or_else(|| format!("{}.toml", kind.name()).into());
    if out == Path::new(STANDARD_INPUT) {
        return super::terminal::print(text);
    }
    let name = out.display();
    let mut file = File::create_new(&out).map_err(|reason| match reason.kind() {
        ErrorKind::AlreadyExists => Error::input(format!("{name}: is there already; name another file with --out")),
        _ => Error::input(format!("{name}: cannot be written: {reason}; name another file with --out")),
    })?;
    let written = file.write_all(text.as_bytes()).inspect_err(|_| drop(std::fs::remove_file(&out)));
    written.map_err(other(format!("{name}: cannot be written")))?;
    super::terminal::note(format_args!("wrote {name}; go on with `plm-impact run {name}`"));
    Ok(())
}
