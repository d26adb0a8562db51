//! `plm-impact check`

use clap::Args;
use plm_impact::error::Error;

use super::scenario::ScenarioArguments;

/// Print what is understood of a scenario, its yield point and the warnings of a run; write nothing
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact check impact.toml
  plm-impact check impact.toml --set sphere.youngs_modulus=rigid --error-format json")]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
}

pub fn check(arguments: &Arguments) -> Result<(), Error> {
    let scenario = arguments.scenario.load()?;
    let outcome = plm_impact::run::check(&scenario)?;
    super::output::warn(&outcome.warnings);
    super::terminal::print(&outcome.text)
}
