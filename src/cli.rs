//! The command line: its types, and one file for each subcommand.

mod bench;
mod check;
mod fit_plm;
mod interrupt;
mod laws;
mod merge;
mod reference;
mod run;
mod schema;
mod sweep;
mod threads;
mod validate;

use std::fmt::Display;
use std::io::{self, Write as _};
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use plm_impact::scenario::{Scenario, ScenarioError};

/// Low-velocity impact of an elastic sphere on an elastic-plastic half-space.
///
/// Exit codes: 0 done, 1 a run failed, 2 the input is wrong, 3 validation missed a
/// tolerance, 130 interrupted by Ctrl-C and 143 by SIGTERM (the same command goes on).
#[derive(Debug, Parser)]
#[command(version)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Bench(bench::Arguments),
    Run(run::Arguments),
    Check(check::Arguments),
    Merge(merge::Arguments),
    Laws(laws::Arguments),
    Schema(schema::Arguments),
    Reference(reference::Arguments),
    Validate(validate::Arguments),
    FitPlm(fit_plm::Arguments),
}

/// A scenario and what the command line changes in it.
#[derive(Debug, Args)]
struct ScenarioArguments {
    /// Scenario file (TOML)
    #[arg(value_name = "FILE")]
    scenario: PathBuf,
    /// Override a key: --set impact.speed="1 m/s"
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl ScenarioArguments {
    fn load(&self) -> Result<Scenario, ScenarioError> {
        Scenario::load(&self.scenario, &self.overrides)
    }
}

/// Does what the command line says.
///
/// # Errors
/// What the subcommand reports, ready to be printed.
pub fn run() -> anyhow::Result<()> {
    match Cli::parse().command {
        Command::Bench(arguments) => bench::bench(&arguments),
        Command::Run(arguments) => run::run(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::Merge(arguments) => merge::merge(&arguments),
        Command::Laws(arguments) => laws::laws(&arguments),
        Command::Schema(arguments) => schema::schema(&arguments),
        Command::Reference(arguments) => reference::reference(&arguments),
        Command::Validate(arguments) => validate::validate(&arguments),
        Command::FitPlm(arguments) => fit_plm::fit_plm(&arguments),
    }
}

/// A line to standard error; one that nobody reads (`2>&1 | head`) is no failure.
pub fn note(line: impl Display) {
    drop(writeln!(io::stderr().lock(), "{}", harmless(&line.to_string())));
}

/// The text without control characters, which names of files and keys may hold and which a terminal obeys.
fn harmless(text: &str) -> String {
    let is_obeyed = |c: char| c.is_control() && c != '\n' && c != '\t';
    text.chars().fold(String::with_capacity(text.len()), |mut shown, c| {
        if is_obeyed(c) {
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
        shown
    })
}

/// Prints a result; a reader that has seen enough (`| head`) is no failure.
fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(harmless(text).as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}
