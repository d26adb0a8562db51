//! The columns of a table as NumPy arrays and as Arrow data. Both share the memory of the numbers.

use std::sync::Arc;

use arrow_array::cast::AsArray as _;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::{Float64Type, Int32Type};
use arrow_array::{ArrayRef, DictionaryArray, Float64Array, RecordBatch, RecordBatchIterator};
use arrow_schema::ArrowError;
use numpy::PyArray1;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyCapsule, PyDict, PyType};

use super::convert::{Reduced, numbers};
use super::rows::NamedColumns;
use crate::table::format::arrow;

/// A column of a table: numbers, NaN where a row has none; or words.
#[pyclass(frozen, module = "plm_impact._core")]
#[derive(Debug)]
pub struct Column(ArrayRef);

impl Column {
    fn as_numbers(&self) -> Option<&Float64Array> {
        self.0.as_primitive_opt::<Float64Type>()
    }

    /// The different words, and for every row the place of its word.
    fn as_words(&self) -> Option<(Vec<&str>, &[i32])> {
        let array = self.0.as_dictionary_opt::<Int32Type>()?;
        Some((array.values().as_string_opt::<i32>()?.iter().flatten().collect(), array.keys().values()))
    }
}

#[pymethods]
impl Column {
    /// The numbers, which NumPy reads without a copy.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(array) = self.as_numbers() else { return Ok(None) };
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("shape", (array.len(),))?;
        interface.set_item("typestr", if cfg!(target_endian = "little") { "<f8" } else { ">f8" })?;
        // `true` makes the array read-only, because Arrow shares its memory
        interface.set_item("data", (array.values().as_ptr().addr(), true))?;
        Ok(Some(interface))
    }

    /// The different words, and for every row the index of its word; `None` for a column of numbers.
    fn categories<'py>(&self, py: Python<'py>) -> Option<(Vec<&str>, Bound<'py, PyArray1<i32>>)> {
        self.as_words().map(|(words, places)| (words, PyArray1::from_slice(py, places)))
    }

    /// The column as a read-only NumPy array with one axis. Rows with the same word share one text: 8 bytes a row.
    fn numpy<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let numpy = slf.py().import("numpy")?;
        match slf.get().as_words() {
            None => numpy.call_method1("asarray", (slf,)),
            Some((words, places)) => {
                let places = PyArray1::from_slice(slf.py(), places);
                let array = numpy.call_method1("array", (words, "object"))?.call_method1("take", (places,))?;
                array.call_method1("setflags", (false,))?;
                Ok(array)
            }
        }
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> Reduced<'py, (Bound<'py, PyAny>,)> {
        let data = match slf.get().as_words() {
            None => Self::numpy(slf)?,
            Some(words) => words.into_pyobject(slf.py())?.into_any(),
        };
        Ok((slf.get_type().getattr("_restore")?, (data,)))
    }

    #[staticmethod]
    fn _restore(data: &Bound<'_, PyAny>) -> PyResult<Self> {
        match data.extract::<(Vec<String>, Vec<i32>)>() {
            Ok((words, places)) => {
                let places: Vec<f64> = places.into_iter().map(f64::from).collect();
                arrow::word_array(&places, &Arc::new(words.into())).map(Self).map_err(arrow_error)
            }
            Err(_) => Ok(Self(arrow::number_array(numbers(data, "column")?.values))),
        }
    }
}

#[allow(clippy::needless_pass_by_value)] // for map_err
fn arrow_error(error: ArrowError) -> PyErr {
    PyRuntimeError::new_err(error.to_string())
}

/// Named columns as Arrow data, without a copy of their numbers.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)] // what Python hands over
pub fn arrow_stream<'py>(
    py: Python<'py>,
    columns: Vec<(String, Bound<'py, Column>)>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let arrays = columns.iter().map(|(name, column)| (name, Arc::clone(&column.get().0), true));
    let batch = RecordBatch::try_from_iter_with_nullable(arrays).map_err(arrow_error)?;
    let schema = batch.schema();
    let reader = RecordBatchIterator::new([Ok(batch)], schema);
    PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(reader)), c"arrow_array_stream")
}

/// A `plm_impact.Table` of these columns, with a row for each case.
pub fn table<'py>(columns: &Bound<'py, PyDict>, rows: usize) -> PyResult<Bound<'py, PyAny>> {
    static TABLE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    TABLE.import(columns.py(), "plm_impact", "Table")?.call1(((rows,), columns))
}

/// These columns, by name.
fn columns(py: Python<'_>, columns: impl IntoIterator<Item = (String, ArrayRef)>) -> PyResult<Bound<'_, PyDict>> {
    let named = PyDict::new(py);
    for (name, array) in columns {
        named.set_item(name, Column(array))?;
    }
    Ok(named)
}

/// Columns of numbers, which are `given`, and the named columns with these values.
pub fn value_columns(
    py: Python<'_>,
    given: impl IntoIterator<Item = (String, Vec<f64>)>,
    named: NamedColumns,
    values: Vec<Vec<f64>>,
) -> PyResult<Bound<'_, PyDict>> {
    let array = |((name, column), values): ((String, crate::table::format::column::TableColumn), Vec<f64>)| match column
        .categories()
    {
        None => Ok((name, arrow::number_array(values))),
        Some(words) => Ok((name, arrow::word_array(&values, &Arc::new(words.into())).map_err(arrow_error)?)),
    };
    let computed = named.into_iter().zip(values).map(array).collect::<PyResult<Vec<_>>>()?;
    columns(py, given.into_iter().map(|(name, values)| (name, arrow::number_array(values))).chain(computed))
}

/// The table of a CSV file. A column holds numbers if all its fields are numbers or empty, else words.
#[pyfunction]
pub fn table_of_csv<'py>(py: Python<'py>, bytes: &[u8]) -> PyResult<Bound<'py, PyAny>> {
    let mut reader = csv::Reader::from_reader(bytes);
    let names = reader.headers().cloned().unwrap_or_default();
    let rows: Vec<csv::StringRecord> = reader.records().flatten().collect();
    let arrays = names.iter().enumerate().map(|(place, name)| {
        let fields = || rows.iter().map(|row| row.get(place).unwrap_or_default());
        let number = |field: &str| if field.is_empty() { Some(f64::NAN) } else { field.parse().ok() };
        let array = match fields().map(number).collect() {
            Some(values) => arrow::number_array(values),
            None => Arc::new(fields().collect::<DictionaryArray<Int32Type>>()),
        };
        (name.to_owned(), array)
    });
    table(&columns(py, arrays)?, rows.len())
}
