//! What a command line asks of a scenario, its results, and their files.

use plm_impact::error::{Error, ErrorKind};
use plm_impact::files::{OutputDirectory, OutputFile};
use plm_impact::report::run::{Outcome, RunOptions, run};
use plm_impact::scenario::Scenario;
use plm_impact::table::FinishedTable;

use super::output::{OutputArguments, command_line, note_replaced};
use super::run::CommandLine;
use super::table::TableRequest;
use super::watch::Watch;

/// A scenario with a directory for its results.
pub struct Request<'a> {
    pub scenario: Scenario,
    pub directory: OutputDirectory,
    pub output: &'a OutputArguments,
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
    pub fn compute(mut self) -> Result<Results<'a>, Error> {
        if let Some(table) = self.table.take() {
            return table.compute(self);
        }
        let Self { scenario, directory, output, .. } = self;
        let (detail, pictures) = (output.detail(), output.pictures.format);
        let (scenario, outcome) = Watch::without_files(output.quiet).watch(move |progress| {
            let outcome = run_whole(&scenario, &RunOptions { command: &command_line(), detail, pictures, progress })?;
            Ok((scenario, outcome))
        })?;
        let Outcome { warnings, text, files, contradiction, .. } = outcome;
        output.print_warnings(&scenario, &warnings)?;
        let flaw = contradiction.map(|reason| Error::for_file(ErrorKind::Mismatch, scenario.document.name(), reason));
        Ok(Results { directory, output, text, files, table: None, removed: Vec::new(), flaw })
    }
}

/// The outcome of a scenario that is not a table.
pub fn run_whole(scenario: &Scenario, options: &RunOptions) -> Result<Outcome, Error> {
    run(scenario, Some(options))?.ok_or_else(|| Error::input("a table is made row after row".to_owned()))
}

/// The results of a scenario.
pub struct Results<'a> {
    pub directory: OutputDirectory,
    pub output: &'a OutputArguments,
    /// For the terminal.
    pub text: String,
    /// The files to be written; a shard of a table has none.
    pub files: Vec<OutputFile>,
    /// A table whose rows are written already.
    pub table: Option<FinishedTable>,
    /// Names of files of the run before that this run does not make.
    pub removed: Vec<String>,
    /// The error with which the command ends once all is written: measurements that contradict the law, or rows without a result.
    pub flaw: Option<Error>,
}

impl Results<'_> {
    /// Writes the files.
    pub fn write(mut self) -> Result<Self, Error> {
        if !self.files.is_empty() {
            self.removed = self.directory.write(&self.files)?;
        }
        Ok(self)
    }

    /// Prints the results, and notes where their files are.
    pub fn report(self) -> Result<(), Error> {
        note_replaced(&self.directory, &self.removed);
        let names = self.files.iter().map(|file| file.name.clone());
        let place = match &self.table {
            None => {
                format!("wrote {} to {}", names.collect::<Vec<_>>().join(", "), self.directory.path().display())
            }
            Some(FinishedTable { table, resumed_rows, .. }) => {
                let names = std::iter::once(table.display().to_string()).chain(names).collect::<Vec<_>>().join(", ");
                match resumed_rows {
                    0 => format!("wrote {names}"),
                    rows => format!("{rows} rows were already computed\nwrote {names}"),
                }
            }
        };
        self.output.report(&self.text, &self.files, place)?;
        self.flaw.map_or(Ok(()), Err)
    }
}
