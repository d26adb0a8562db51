//! The results of a command, their files, and the words about them.

use std::path::Path;

use plm_impact::error::Error;
use plm_impact::files::{OutputDirectory, OutputFile};
use plm_impact::table::FinishedTable;

use super::output::{DEFAULT_FOLDER, OutputArguments, note_replaced};

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
        // nobody asked for the default folder
        let is_new = self.directory.has_made(Path::new(DEFAULT_FOLDER));
        let made = if is_new {
            format!("\n{DEFAULT_FOLDER} is a new folder; --out names another folder")
        } else {
            String::new()
        };
        self.output.report(&self.text, &self.files, place + &made)?;
        self.flaw.map_or(Ok(()), Err)
    }
}
