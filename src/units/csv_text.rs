//! CSV as people and spreadsheets write it: with a byte order mark, comment lines that begin with `#`, empty lines, and
//! spaces around values.

use csv::{Position, Reader, ReaderBuilder, StringRecord, Trim};

use crate::error::{Details, Error};

/// The line, counted from 1, and what is wrong there.
pub type Refusal = (Option<u64>, String);

/// The error of a refusal in the file of this name.
pub(crate) fn refused(name: &str) -> impl Fn(Refusal) -> Error + Copy {
    move |(line, message)| {
        let at = line.map(|line| format!(":{line}")).unwrap_or_default();
        let told = Error::input(format!("{name}{at}: {message}"));
        told.with(Details { message: Some(message), file: Some(name.to_owned()), line, ..Details::default() })
    }
}

/// A text of which the names of the columns have been read.
#[derive(Debug)]
pub struct CsvText<'t> {
    /// The names of the columns.
    pub header: StringRecord,
    /// The line of the header, counted from 1.
    pub line: Option<u64>,
    text: &'t str,
    reader: Reader<&'t [u8]>,
}

impl<'t> CsvText<'t> {
    /// Reads the names of the columns.
    ///
    /// # Errors
    /// [`Refusal`] if something other than commas separates the columns.
    pub fn new(text: &'t str) -> Result<Self, Refusal> {
        let text = without_mark(text);
        let mut reader = ReaderBuilder::new().comment(Some(b'#')).trim(Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| (None, error.to_string()))?.clone();
        let line = header.position().map(|position| line_at(text, position));
        if header.len() == 1 && header[0].contains([';', '\t']) {
            let message = "the columns are not separated by commas: write a,b,c, with decimal points";
            return Err((line, message.to_owned()));
        }
        Ok(Self { header, line, text, reader })
    }

    /// The rows below the header, each with its line.
    pub fn rows(self) -> impl Iterator<Item = Result<(u64, StringRecord), Refusal>> {
        let Self { header, text, reader, .. } = self;
        reader.into_records().map(move |record| match record {
            Ok(record) => Ok((record.position().map_or(0, |position| line_at(text, position)), record)),
            Err(error) => {
                let line = error.position().map(|position| line_at(text, position));
                Err((line, format!("this line has not as many values as there are columns ({})", header.len())))
            }
        })
    }
}

/// The text without the byte order mark that spreadsheets put before it.
fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// The line of the row that begins at this place. The reader counts comments and empty lines as the beginning of the row
/// that follows them.
fn line_at(text: &str, position: &Position) -> u64 {
    let rest = usize::try_from(position.byte()).ok().and_then(|byte| text.get(byte..)).unwrap_or_default();
    let skipped = rest.lines().take_while(|line| line.is_empty() || line.starts_with('#')).count();
    position.line() + skipped as u64
}
