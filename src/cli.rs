//! The command line: its types, and one file for each subcommand.

mod bench;
mod calibrate;
mod check;
mod export;
mod fit_plm;
mod interrupt;
mod laws;
mod materials;
mod merge;
mod reference;
mod run;
mod scenario;
mod schema;
mod sweep;
pub mod terminal;
mod threads;
mod validate;

use clap::{Parser, Subcommand};

/// Low-velocity impact of an elastic sphere on an elastic-plastic half-space.
///
/// Exit codes: 0 done, 1 a run failed, 2 the input is wrong, 3 validation missed a
/// tolerance, or measurements contradict the law, 130 interrupted by Ctrl-C and 143 by SIGTERM (the same command goes on).
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
    Calibrate(calibrate::Arguments),
    Export(export::Arguments),
    Merge(merge::Arguments),
    Laws(laws::Arguments),
    Materials(materials::Arguments),
    Schema(schema::Arguments),
    Reference(reference::Arguments),
    Validate(validate::Arguments),
    FitPlm(fit_plm::Arguments),
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
        Command::Calibrate(arguments) => calibrate::calibrate(&arguments),
        Command::Export(arguments) => export::export(&arguments),
        Command::Merge(arguments) => merge::merge(&arguments),
        Command::Laws(arguments) => laws::laws(&arguments),
        Command::Materials(arguments) => materials::materials(&arguments),
        Command::Schema(arguments) => schema::schema(&arguments),
        Command::Reference(arguments) => reference::reference(&arguments),
        Command::Validate(arguments) => validate::validate(&arguments),
        Command::FitPlm(arguments) => fit_plm::fit_plm(&arguments),
    }
}
