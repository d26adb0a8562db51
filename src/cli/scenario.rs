//! The scenario among the arguments of a command.

use std::io::stdin;
use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::scenario::{LARGEST_SCENARIO, Scenario, text_of};

/// What stands for standard input in place of a file.
pub const STANDARD_INPUT: &str = "-";

/// A scenario and what the command line changes in it.
#[derive(Debug, Args)]
pub struct ScenarioArguments {
    /// Scenario file (TOML); - is standard input, and files that it names are then relative to the current directory
    #[arg(value_name = "FILE")]
    scenario: PathBuf,
    /// Override a key: --set impact.speed="1 m/s", choose a law: --set law=thornton, or take a key away: --set gravity=none
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl ScenarioArguments {
    /// The name of the scenario in messages and outputs.
    pub fn name(&self) -> &Path {
        if self.is_standard_input() { Path::new("stdin") } else { &self.scenario }
    }

    fn is_standard_input(&self) -> bool {
        self.scenario == Path::new(STANDARD_INPUT)
    }

    /// Another file with the same overrides.
    pub fn of(&self, file: &Path) -> Self {
        Self { scenario: file.to_owned(), overrides: self.overrides.clone() }
    }

    pub fn load(&self) -> Result<Scenario, Error> {
        self.load_with(&[])
    }

    /// Loads the scenario with more overrides than those of the command line.
    pub fn load_with(&self, more: &[String]) -> Result<Scenario, Error> {
        let overrides = [&self.overrides, more].concat();
        if self.is_standard_input() {
            let text = text_of(self.name(), stdin().lock(), LARGEST_SCENARIO)?;
            return Scenario::from_text("stdin", &text, &overrides);
        }
        Scenario::load(&self.scenario, &overrides)
    }
}
