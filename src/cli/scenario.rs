//! The scenario among the arguments of a command.

use std::path::PathBuf;

use clap::Args;
use plm_impact::scenario::{Scenario, ScenarioError};

/// A scenario and what the command line changes in it.
#[derive(Debug, Args)]
pub struct ScenarioArguments {
    /// Scenario file (TOML)
    #[arg(value_name = "FILE")]
    pub scenario: PathBuf,
    /// Override a key: --set impact.speed="1 m/s"
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl ScenarioArguments {
    pub fn load(&self) -> Result<Scenario, ScenarioError> {
        self.load_with(&[])
    }

    /// The same with more overrides.
    pub fn load_with(&self, more: &[String]) -> Result<Scenario, ScenarioError> {
        Scenario::load(&self.scenario, &[&self.overrides, more].concat())
    }
}
