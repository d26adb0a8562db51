//! The scenario among the arguments of a command.

use std::io::{ErrorKind, stdin};
use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::files::create;
use plm_impact::scenario::{MAX_SCENARIO_MIB, Override, Scenario, read_open_file};

/// In place of a file it stands for standard input.
pub const STANDARD_INPUT: &str = "-";

/// Writes a scenario to a file, never over one that is there. `option` is the one that names another file.
pub fn write_new_scenario(path: &Path, text: &str, option: &str) -> Result<(), Error> {
    let name = path.display();
    create(path, text.as_bytes()).map_err(|reason| match reason.kind() {
        ErrorKind::AlreadyExists => Error::input(format!("{name} already exists. Choose another file with {option}.")),
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            Error::failed(format!("{name}: cannot be written: {reason}"))
        }
        _ => Error::input(format!("{name}: cannot be written: {reason}. Choose another file with {option}.")),
    })?;
    super::terminal::note(format_args!("wrote {name}. Next: `plm-impact run {name}`"));
    Ok(())
}

/// A scenario and what the command line changes in it.
#[derive(Debug, Clone, Args)]
pub struct ScenarioArguments {
    /// Scenario file (TOML); - is standard input, and files that it names are then relative to the current directory
    #[arg(value_name = "FILE")]
    scenario: PathBuf,
    /// Override a key (impact.speed="1 m/s"), select a law (law=thornton) or remove a key (gravity=none); repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl ScenarioArguments {
    /// The name of the scenario in messages and outputs.
    pub fn name(&self) -> &Path {
        if self.is_standard_input() { Path::new("stdin") } else { &self.scenario }
    }

    /// The file; `None` for standard input.
    pub fn file(&self) -> Option<&Path> {
        Some(self.name()).filter(|_| !self.is_standard_input())
    }

    /// The settings of --set.
    pub fn settings(&self) -> &[String] {
        &self.overrides
    }

    fn is_standard_input(&self) -> bool {
        self.scenario == Path::new(STANDARD_INPUT)
    }

    /// Another file with the same overrides.
    pub fn with_file(&self, file: &Path) -> Self {
        Self { scenario: file.to_owned(), overrides: self.overrides.clone() }
    }

    pub fn load(&self) -> Result<Scenario, Error> {
        self.load_with(&[])
    }

    /// Loads the scenario with more overrides than those of --set.
    pub fn load_with(&self, more: &[Override]) -> Result<Scenario, Error> {
        let overrides = [&Override::list(&self.overrides), more].concat();
        if self.is_standard_input() {
            let text = read_open_file(self.name(), stdin().lock(), MAX_SCENARIO_MIB)?;
            return Scenario::from_text("stdin", &text, &overrides);
        }
        Scenario::load(&self.scenario, &overrides)
    }
}
