//! `plm-impact run` and `plm-impact check`

use std::path::PathBuf;

use clap::Args;
use plm_impact::error::{Error, ErrorKind};
use plm_impact::report::run::Outcome;
use plm_impact::scenario::Override;
use serde_json::Value;

use super::output::OutputArguments;
use super::request::{CommandLine, Request};
use super::scenario::ScenarioArguments;

/// Run a scenario and write summary, trace and plots
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact run impact.toml --set impact.speed=\"1 m/s\" --pictures svg
  plm-impact run impact.toml sweep.toml --set law=thornton")]
pub struct RunArguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    /// Additional scenarios, each with a separate output directory
    #[arg(value_name = "FILES")]
    more: Vec<PathBuf>,
    /// Override the impact speed, as --set impact.speed="2 m/s"
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
    #[command(flatten)]
    output: OutputArguments,
    #[command(flatten)]
    table: super::table::Options,
}

pub fn run(arguments: &RunArguments) -> Result<(), Error> {
    if arguments.more.is_empty() {
        return run_file(arguments, &arguments.scenario);
    }
    arguments.output.refuse_shared_directory()?;
    let mut files = vec![arguments.scenario.clone()];
    files.extend(arguments.more.iter().map(|file| arguments.scenario.with_file(file)));
    refuse_same_names(&files)?;
    let mut failed: Vec<(String, ErrorKind, u8)> = Vec::new();
    for file in &files {
        match run_file(arguments, file) {
            Ok(()) => {}
            // a signal is meant for all files
            Err(error) if matches!(error.kind, ErrorKind::Stopped(_)) => return Err(error),
            Err(error) => failed.push((file.name().display().to_string(), error.kind, super::terminal::error(&error))),
        }
    }
    let Some((_, kind, _)) = failed.iter().max_by_key(|(.., code)| *code) else { return Ok(()) };
    let names: Vec<String> = failed.iter().map(|(name, _, code)| format!("{name} (exit code {code})")).collect();
    Err(Error::new(*kind, format!("{} of {} scenarios failed: {}", failed.len(), files.len(), names.join(", "))))
}

/// Refuses two files that would have the same default directory.
fn refuse_same_names(files: &[ScenarioArguments]) -> Result<(), Error> {
    for (at, file) in files.iter().enumerate() {
        let is_like = |other: &&ScenarioArguments| {
            other.name() != file.name() && other.name().file_stem() == file.name().file_stem()
        };
        if let Some(other) = files[..at].iter().find(is_like) {
            let [one, other] = [other, file].map(|file| file.name().display().to_string());
            return Err(Error::input(format!(
                "{one} and {other} have the same name, and their results would go to the same directory; run one file at a time, each with its own --out"
            )));
        }
    }
    Ok(())
}

/// Runs one of the files.
fn run_file(arguments: &RunArguments, file: &ScenarioArguments) -> Result<(), Error> {
    let speed = arguments.speed.iter().map(|speed| Override::of_option("--speed", "impact.speed", speed));
    let RunArguments { output, table, .. } = arguments;
    run_scenario(&CommandLine { file, overrides: speed.collect(), output, table, is_calibration: false })
}

/// The way of every scenario: of one impact, of a series, of an indentation, of a table, and of a calibration.
pub fn run_scenario(line: &CommandLine) -> Result<(), Error> {
    let scenario = line.file.load_with(&line.overrides)?;
    let request = Request::new(scenario, line)?;
    let results = request.compute()?;
    let written = results.write()?;
    written.report()
}

/// Validate a scenario: print values in SI, yield point and warnings
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact check impact.toml
  plm-impact check impact.toml --set sphere.youngs_modulus=rigid --json")]
pub struct CheckArguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    /// Print JSON: inputs in SI, the numbers that follow from them, and the warnings
    #[arg(long)]
    json: bool,
}

pub fn check(arguments: &CheckArguments) -> Result<(), Error> {
    let scenario = arguments.scenario.load()?;
    let outcome = plm_impact::report::run::check(&scenario)?;
    super::output::print_warnings(&outcome.warnings);
    if !arguments.json {
        return super::terminal::print(&outcome.terminal_text());
    }
    let Outcome { warnings, mut checked, .. } = outcome;
    checked.insert("kind".to_owned(), scenario.kind()?.name().into());
    checked.insert("warnings".to_owned(), warnings.into());
    super::terminal::print_json(&format!("{:#}\n", Value::Object(checked)))
}
