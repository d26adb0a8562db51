//! CSV as people and spreadsheets write it: with a byte order mark, comment lines that begin with `#`, empty lines, and
//! spaces around values. Semicolons or tabs may stand between the columns, and the numbers may then have decimal commas, as
//! spreadsheets write them in many countries.

use csv::{ErrorKind, Position, Reader, ReaderBuilder, StringRecord, Trim};

/// The line, counted from 1, and what is wrong there.
pub type CsvError = (Option<u64>, String);

/// A text of which the names of the columns have been read.
#[derive(Debug)]
pub struct CsvReader<'t> {
    /// The names of the columns.
    pub header: StringRecord,
    /// The line of the header, counted from 1.
    pub line: Option<u64>,
    text: &'t str,
    /// `None` where commas separate the columns.
    decimals: Option<DecimalSigns>,
    reader: Reader<&'t [u8]>,
}

impl<'t> CsvReader<'t> {
    /// Reads the names of the columns.
    pub fn new(text: &'t str) -> Result<Self, CsvError> {
        // spreadsheets put a byte order mark before it
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let separator = separator(text);
        let mut reader =
            ReaderBuilder::new().delimiter(separator).comment(Some(b'#')).trim(Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| (None, error.to_string()))?.clone();
        let line = header.position().map(|position| line_at(text, position));
        Ok(Self { header, line, text, decimals: (separator != b',').then(DecimalSigns::default), reader })
    }

    /// The rows below the header, each with its line. Numbers have decimal points.
    pub fn rows(self) -> impl Iterator<Item = Result<(u64, StringRecord), CsvError>> {
        let Self { header, text, mut decimals, reader, .. } = self;
        reader.into_records().map(move |record| match record {
            Ok(record) => {
                let line = record.position().map_or(0, |position| line_at(text, position));
                let Some(decimals) = &mut decimals else { return Ok((line, record)) };
                Ok((line, decimals.with_decimal_points(&record).map_err(|message| (Some(line), message))?))
            }
            Err(error) => {
                let line = error.position().map(|position| line_at(text, position));
                let hint = if decimals.is_some() {
                    ""
                } else {
                    ". If the numbers have decimal commas, write semicolons between the columns, in the first line too"
                };
                let count = header.len();
                let values = match error.kind() {
                    ErrorKind::UnequalLengths { len, .. } => format!(" (values: {len}, columns: {count})"),
                    _ => format!(" (columns: {count})"),
                };
                Err((line, format!("this line must have one value per column{values}{hint}")))
            }
        })
    }
}

/// The character between the columns: a semicolon or a tab, if the names of the columns have one and no comma.
fn separator(text: &str) -> u8 {
    let names = text.lines().find(|line| !line.is_empty() && !line.starts_with('#')).unwrap_or_default();
    let of_spreadsheets = || [b';', b'\t'].into_iter().find(|sign| names.as_bytes().contains(sign));
    Some(names).filter(|names| !names.contains(',')).and_then(|_| of_spreadsheets()).unwrap_or(b',')
}

/// The decimal signs that the numbers of a file have had so far, each with an example.
#[derive(Debug, Default)]
struct DecimalSigns {
    comma: Option<String>,
    point: Option<String>,
}

impl DecimalSigns {
    /// The row with decimal points. A file that has both signs is refused: one of them may stand between thousands.
    fn with_decimal_points(&mut self, row: &StringRecord) -> Result<StringRecord, String> {
        let mut plain = StringRecord::new();
        for field in row {
            let pointed = field.replacen(',', ".", 1);
            let is_number = pointed.parse::<f64>().is_ok_and(f64::is_finite) && pointed.contains('.');
            if is_number {
                let sign = if field.contains(',') { &mut self.comma } else { &mut self.point };
                sign.get_or_insert_with(|| field.to_owned());
            }
            plain.push_field(if is_number { &pointed } else { field });
        }
        match (&self.comma, &self.point) {
            (Some(comma), Some(point)) => Err(format!(
                "the file has numbers with decimal commas ({comma}) and with decimal points ({point}); use one decimal sign, and no thousands separators"
            )),
            _ => Ok(plain),
        }
    }
}

/// The line of the row that begins at this place. The reader counts comments and empty lines as the beginning of the row
/// that follows them.
fn line_at(text: &str, position: &Position) -> u64 {
    let rest = usize::try_from(position.byte()).ok().and_then(|byte| text.get(byte..)).unwrap_or_default();
    let skipped = rest.lines().take_while(|line| line.is_empty() || line.starts_with('#')).count();
    position.line() + skipped as u64
}
