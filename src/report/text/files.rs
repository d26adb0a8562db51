//! The form in which results are written: `summary.json`, and tables as CSV, such as the trace of an impact and the impacts of a
//! series. A number has the fewest digits that read back to the same number.

use serde_json::{Map, Value};

use super::inputs::Inputs;
use crate::error::Error;
use crate::files::Provenance;
use crate::impact::{Impact, Pulse};
use crate::results::pulse::{pulse_results, spectrum_results};
use crate::results::{ResultSpec, trace};

/// `summary.json`: these results, inputs and provenance, in SI, with the unit in every name, and a newline at its end.
pub fn summary_json(
    mut results: Map<String, Value>,
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, Error> {
    results.insert("inputs".to_owned(), inputs.to_json().into());
    results.insert("provenance".to_owned(), serde_json::to_value(provenance)?);
    Ok(serde_json::to_string_pretty(&results)? + "\n")
}

/// The rows as CSV with a header line. A column with a condition is written if any row has a
/// value for it.
pub fn csv_bytes<T>(columns: &[ResultSpec<T>], rows: impl Iterator<Item = T> + Clone) -> Result<Vec<u8>, Error> {
    csv_bytes_after(&[], columns, rows.map(|row| (&[][..], row)))
}

/// A CSV file whose rows begin with the values of these further columns.
pub(super) fn csv_bytes_after<'a, T>(
    first_names: &[String],
    columns: &[ResultSpec<T>],
    rows: impl Iterator<Item = (&'a [Value], T)> + Clone,
) -> Result<Vec<u8>, Error> {
    let is_there = |column: &&ResultSpec<T>| {
        column.condition.is_empty() || rows.clone().any(|(_, row)| (column.value)(&row).is_some())
    };
    let columns: Vec<_> = columns.iter().filter(is_there).collect();
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    let names = columns.iter().map(|column| column.name);
    writer.write_record(first_names.iter().map(String::as_str).chain(names))?;
    let mut fields = Vec::new();
    for (first, row) in rows {
        fields.clear();
        fields.extend(first.iter().cloned().map(Some));
        fields.extend(columns.iter().map(|column| (column.value)(&row)));
        writer.serialize(&fields)?;
    }
    into_bytes(writer)
}

/// The bytes that were written.
pub fn into_bytes(writer: csv::Writer<Vec<u8>>) -> Result<Vec<u8>, Error> {
    writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
}

/// `pulse.csv` of one impact.
pub fn pulse_csv(pulse: &Pulse) -> Result<Vec<u8>, Error> {
    csv_bytes(&pulse_results(), pulse.samples())
}

/// `spectrum.csv` of one impact.
pub fn spectrum_csv(pulse: &Pulse) -> Result<Vec<u8>, Error> {
    csv_bytes(&spectrum_results(), pulse.lines())
}

/// `trace.csv` of one impact; only the header for an impact that recorded none.
pub fn trace_csv(impact: &Impact) -> Result<Vec<u8>, Error> {
    csv_bytes(&trace::trace_results(), impact.trace.iter().copied())
}
