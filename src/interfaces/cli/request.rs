//! A command line and its scenario: the request, the results, and their files.

use plm_impact::error::{Error, ErrorKind};
use plm_impact::files::OutputDirectory;
use plm_impact::report::run::{Outcome, RunOptions, run};
use plm_impact::scenario::{Override, Scenario};

use super::output::{OutputArguments, command_line};
use super::results::Results;
use super::scenario::ScenarioArguments;
use super::table::TableRequest;
use super::watch::Watch;

/// A command line that runs a scenario.
pub struct CommandLine<'a> {
    pub file: &'a ScenarioArguments,
    /// The keys that options other than --set change.
    pub overrides: Vec<Override>,
    pub output: &'a OutputArguments,
    pub table: &'a super::table::Options,
    /// True if the scenario has to be a calibration.
    pub is_calibration: bool,
}

/// A scenario with a directory for its results.
pub struct Request<'a> {
    scenario: Scenario,
    directory: OutputDirectory,
    output: &'a OutputArguments,
    /// `None` for a scenario whose results are all in memory at once.
    table: Option<TableRequest>,
}

impl<'a> Request<'a> {
    /// Refuses what the kind of the scenario does not have, and opens the directory.
    pub fn new(mut scenario: Scenario, line: &CommandLine<'a>) -> Result<Self, Error> {
        let identity = scenario.identity()?;
        if line.is_calibration {
            scenario.calibration_request()?;
        }
        let table = if identity.kind.is_table() {
            Some(TableRequest::new(&scenario, line.table, line.output)?)
        } else {
            line.table.refuse_for(identity.kind.description())?;
            None
        };
        let directory = line.output.open_directory(line.file.name(), &identity)?;
        scenario.from_results = directory.relative_path(line.file.name());
        Ok(Self { scenario, directory, output: line.output, table })
    }

    /// The results. The rows of a table are written while they are computed.
    pub fn compute(self) -> Result<Results<'a>, Error> {
        let Self { scenario, directory, output, table } = self;
        if let Some(table) = table {
            return table.compute(&scenario, directory, output);
        }
        let (detail, pictures) = (output.detail(), output.pictures.format);
        let (scenario, outcome) = Watch::without_files(output.quiet).watch(move |progress| {
            let outcome = run_whole(&scenario, &RunOptions { command: &command_line(), detail, pictures, progress })?;
            Ok((scenario, outcome))
        })?;
        let text = outcome.terminal_text();
        let Outcome { warnings, files, contradiction, .. } = outcome;
        output.print_warnings(&scenario, &warnings)?;
        let flaw = contradiction.map(|reason| Error::for_file(ErrorKind::Mismatch, scenario.document.name(), reason));
        Ok(Results { directory, output, text, files, table: None, removed: Vec::new(), flaw })
    }
}

/// The outcome of a scenario that is not a table.
pub fn run_whole(scenario: &Scenario, options: &RunOptions) -> Result<Outcome, Error> {
    run(scenario, Some(options))?.ok_or_else(|| Error::input("a table is made row after row".to_owned()))
}
