//! `plm-impact run` and `plm-impact check`

use std::path::PathBuf;

use clap::Args;
use plm_impact::error::Error;
use plm_impact::report::run::Outcome;
use serde_json::Value;

use super::output::Output;
use super::scenario::ScenarioArguments;

/// Run a scenario: summary, trace and pictures into a directory, a table to the terminal
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact run impact.toml --set impact.speed=\"1 m/s\" --pictures svg
  plm-impact run impact.toml sweep.toml --set law=thornton")]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    /// More scenario files; each is run with the same options into a directory of its own
    #[arg(value_name = "FILES")]
    more: Vec<PathBuf>,
    /// Impact speed in place of that of the scenario, as --set impact.speed="2 m/s"
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
    #[command(flatten)]
    output: Output,
    #[command(flatten)]
    sweep: super::sweep::Options,
}

pub fn run(arguments: &Arguments) -> Result<(), Error> {
    if !arguments.more.is_empty() {
        arguments.output.refuse_one_directory()?;
    }
    one(arguments, &arguments.scenario)?;
    arguments.more.iter().try_for_each(|file| one(arguments, &arguments.scenario.with_file(file)))
}

/// Runs one of the files.
fn one(arguments: &Arguments, file: &ScenarioArguments) -> Result<(), Error> {
    let speed = arguments.speed.as_ref().map(|speed| format!("impact.speed={speed}"));
    let mut scenario = file.load_with(speed.as_slice())?;
    let kind = scenario.kind()?;
    if kind.is_table() {
        return super::sweep::run(&arguments.sweep, &arguments.output, file.name(), &mut scenario);
    }
    arguments.sweep.refuse_for(kind.what())?;
    arguments.output.once(file.name(), scenario)
}

/// Print what is understood of a scenario, its yield point and the warnings of a run; write nothing
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
    let Outcome { warnings, text, mut checked, .. } = plm_impact::report::run::check(&scenario)?;
    super::output::warn(&warnings);
    if !arguments.json {
        return super::terminal::print(&text);
    }
    checked.insert("kind".to_owned(), scenario.kind()?.name().into());
    checked.insert("warnings".to_owned(), warnings.into());
    super::terminal::print_json(&format!("{:#}\n", Value::Object(checked)))
}
