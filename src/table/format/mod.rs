//! The file formats of a table. A format is added as a value of [`Format`] and an implementation of the trait `TableEncoder`: see `csv.rs` and
//! `parquet.rs`.

#[cfg(any(feature = "parquet", feature = "python"))]
pub(crate) mod arrow;
pub(crate) mod column;
pub mod csv;
#[cfg(feature = "parquet")]
pub(in crate::table) mod parquet;

use std::io;
use std::path::Path;

use serde::Serialize;

use super::Rows;
use super::tally::RowOutcome;
use crate::files::AtomicFile;
use crate::strings::named_enum;

named_enum! {
    /// The file format of a table; its name is the extension, and the word on the command line.
    #[derive(Serialize)]
    #[serde(rename_all = "lowercase")]
    pub enum Format {
        /// Comma-separated values with one header line.
        Csv = "csv",
        /// Parquet; needs the cargo feature `parquet`.
        Parquet = "parquet",
    }
}

/// A file format: it encodes rows, writes them into a file, and reads such a file again.
pub(super) trait TableEncoder: Sync + Send {
    /// Encoded rows.
    type Chunk: Send;
    /// A file that is being written.
    type Writer: Send;

    /// The most rows that are encoded at a time.
    const BATCH_ROWS: u64;

    /// Every file begins with these bytes.
    fn header(&self) -> &[u8];

    /// True if this program wrote the file as a table.
    fn is_own(&self, path: &Path) -> io::Result<bool>;

    /// Encodes rows; many threads do so at a time.
    fn encode(&self, rows: &Rows) -> io::Result<Self::Chunk>;

    fn begin(&self, file: AtomicFile) -> io::Result<Self::Writer>;

    /// Appends the next rows.
    fn append(&self, writer: &mut Self::Writer, piece: &Self::Chunk) -> io::Result<()>;

    /// Ends the file, which is then complete but not yet in its place.
    fn finish(&self, writer: Self::Writer) -> io::Result<AtomicFile>;

    /// Reads a file that should have `rows` rows, and counts them. Returns false as soon as it finds that the file is not whole.
    fn read(&self, path: &Path, rows: u64, count: &mut dyn FnMut(RowOutcome)) -> io::Result<bool>;
}
