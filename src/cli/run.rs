//! `plm-impact run`

use clap::Args;
use plm_impact::error::Error;
use plm_impact::output::OutputDirectory;
use plm_impact::run::{Run, heed, table, way};
use plm_impact::scenario::Scenario;

use super::output::{Output, warn};
use super::scenario::ScenarioArguments;

/// Run a scenario: summary, trace and pictures into a directory, a table to the terminal
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact run impact.toml --set impact.speed=\"1 m/s\" --pictures svg
  plm-impact run sweep.toml --set law=thornton --out thornton")]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    #[command(flatten)]
    output: Output,
    #[command(flatten)]
    sweep: super::sweep::Options,
}

pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let scenario = arguments.scenario.load().map_err(Error::from)?;
    match way(scenario.kind().map_err(Error::from)?).run {
        Run::Once { what, run } => {
            arguments.sweep.refuse_for(what)?;
            arguments.output.once(arguments.scenario.name(), scenario, run)
        }
        Run::Table => sweep(arguments, &scenario),
    }
}

fn sweep(arguments: &Arguments, scenario: &Scenario) -> anyhow::Result<()> {
    let plan = table::plan(scenario)?;
    let warnings = table::warnings(&plan);
    warn(&warnings);
    let (output, file) = (&arguments.output, arguments.scenario.name());
    heed(scenario, warnings.len(), output.strict)?;
    let directory = if arguments.sweep.shard()?.is_none() {
        output.prepare(file, scenario)?
    } else {
        // every shard is checked by itself
        OutputDirectory::shared(&output.directory(file)).map_err(Error::from)?
    };
    super::sweep::run(&arguments.sweep, scenario, &plan, &warnings, &directory, output)
}
