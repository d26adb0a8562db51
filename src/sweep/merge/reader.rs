//! Reads the rows of one shard and checks each of them.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use crate::sweep::SweepError;
use crate::sweep::count::Count;
use crate::sweep::seal::{Seal, Sealed, Sum};
use crate::sweep::shard::Layout;
use crate::sweep::table::TextTable;

/// A file that is open only during a read, so that the limit on open files does not limit the number of shards.
#[derive(Debug)]
struct Closed {
    path: PathBuf,
    at: u64,
}

impl Read for Closed {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let mut file = File::open(&self.path)?;
        file.seek(SeekFrom::Start(self.at))?;
        let read = file.read(bytes)?;
        self.at += read as u64;
        Ok(read)
    }
}

/// Reads a shard from its first row to its end.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    input: BufReader<Sealed<Closed>>,
    path: &'a Path,
    table: &'a TextTable,
    rows: u64,
    /// Rows read.
    read: u64,
    /// The line at hand, with its end.
    line: Vec<u8>,
}

impl<'a> Reader<'a> {
    /// Opens a shard and checks its header. `buffer` is the number of bytes read at a time.
    pub(super) fn open(
        path: &'a Path,
        table: &'a TextTable,
        layout: &Layout,
        buffer: usize,
    ) -> Result<Self, SweepError> {
        let file = Sealed::new(Closed { path: path.to_owned(), at: 0 }, Sum::default());
        let input = BufReader::with_capacity(buffer, file);
        let mut reader = Self { input, path, table, rows: layout.rows(), read: 0, line: Vec::new() };
        reader.next_line()?;
        if reader.line == table.header() { Ok(reader) } else { Err(damaged(path, "its first line")) }
    }

    fn next_line(&mut self) -> Result<(), SweepError> {
        self.line.clear();
        let read = self.input.read_until(b'\n', &mut self.line);
        read.map(drop).map_err(SweepError::file("cannot be read", self.path))
    }

    /// Reads the next row, which has to be this case: how it counts, and its line with the line end.
    pub(super) fn row(&mut self, case: u64) -> Result<(Count, &[u8]), SweepError> {
        self.next_line()?;
        self.read += 1;
        let line = self.line.strip_suffix(b"\n");
        let row = line.and_then(|line| self.table.read(line, self.read == self.rows));
        match row.filter(|(read, _)| *read == case) {
            Some((_, count)) => Ok((count, &self.line)),
            None => Err(damaged(self.path, &format!("row {}, which should be case {case},", self.read))),
        }
    }

    /// Whether the file ends after its last row, and has this seal.
    pub(super) fn ends_with(mut self, seal: Seal) -> Result<bool, SweepError> {
        self.next_line()?;
        let is_end = self.line == self.table.footer();
        // reads what may follow, so that the seal covers it too
        self.next_line()?;
        Ok(is_end && self.line.is_empty() && self.input.get_ref().seal() == seal)
    }
}

fn damaged(path: &Path, what: &str) -> SweepError {
    let problem = format!("{what} is not what was written; run its command again, which makes the shard anew");
    SweepError::Damaged { path: path.to_owned(), problem }
}
