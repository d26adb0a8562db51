//! Columns of a table as numbers and as Arrow data, for Parquet and for Python.

use std::sync::Arc;

use arrow_array::types::Int32Type;
use arrow_array::{ArrayRef, DictionaryArray, Float64Array, Int32Array, StringArray};
use arrow_schema::ArrowError;

use super::column::TableColumn;
use crate::impact::ImpactRow;
use crate::table::tally::OK;
use crate::table::{RowFailure, Rows};

/// The number of a failure: its index in the words of the column `status`. A row with results has 0.
pub(crate) fn failure_code(failure: RowFailure) -> f64 {
    f64::from(failure as u8 + 1)
}

/// The failure with this number; `None` for a row with results.
#[cfg(feature = "python")]
pub(crate) fn failure_of_code(place: f64) -> Option<RowFailure> {
    RowFailure::ALL.into_iter().find(|failure| failure_code(*failure) == place)
}

impl TableColumn {
    /// The words of the column; `None` for one of numbers.
    pub(crate) fn categories(&self) -> Option<Vec<String>> {
        match self {
            Self::AxisWord(_, names) => Some(names.clone()),
            Self::Status => {
                Some([OK].into_iter().chain(RowFailure::ALL.map(RowFailure::name)).map(str::to_owned).collect())
            }
            Self::Case | Self::Value(_) | Self::AxisValue(..) | Self::Result(_) => None,
        }
    }

    /// The values of these rows. A missing value is NaN, and a word is its position in the list of words.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole numbers
    pub(crate) fn values(&self, rows: &Rows) -> Vec<f64> {
        let n_swept = rows.axis_values.len().checked_div(rows.results.len()).unwrap_or(0).max(1);
        let swept = |place: usize| rows.axis_values.chunks_exact(n_swept).map(move |row| row[place]);
        match self {
            Self::Case => rows.cases.iter().map(|case| *case as f64).collect(),
            Self::Value(place) | Self::AxisWord(place, _) => swept(*place).collect(),
            Self::AxisValue(place, values) => swept(*place).map(|place| values.value_at(place as u64)).collect(),
            Self::Result(column) => {
                let value = |row: &Result<ImpactRow, _>| row.as_ref().ok().and_then(column.value);
                rows.results.iter().map(|row| value(row).unwrap_or(f64::NAN)).collect()
            }
            Self::Status => {
                rows.results.iter().map(|row| row.as_ref().err().map_or(0.0, |why| failure_code(*why))).collect()
            }
        }
    }
}

/// A column of numbers, which keep their memory. NaN is a missing value.
pub(crate) fn number_array(values: Vec<f64>) -> ArrayRef {
    let array = Float64Array::from(values);
    let is_known = array.values().iter().map(|value| !value.is_nan());
    if is_known.clone().all(|known| known) {
        return Arc::new(array);
    }
    let known = is_known.collect();
    Arc::new(Float64Array::new(array.values().clone(), Some(known)))
}

/// A column of words, each by its place among the different words.
#[allow(clippy::cast_possible_truncation)] // places in a short list
pub(crate) fn word_array(places: &[f64], words: &Arc<StringArray>) -> Result<ArrayRef, ArrowError> {
    let codes = Int32Array::from_iter_values(places.iter().map(|place| *place as i32));
    Ok(Arc::new(DictionaryArray::<Int32Type>::try_new(codes, Arc::clone(words) as ArrayRef)?))
}
