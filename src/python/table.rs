//! A table of named columns, as NumPy arrays and as Arrow data. Both share the memory of the numbers.

use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::Int32Type;
use arrow_array::{ArrayRef, DictionaryArray, Float64Array, Int32Array, RecordBatch, RecordBatchIterator, StringArray};
use arrow_schema::ArrowError;
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::exceptions::{PyImportError, PyKeyError, PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict, PyIterator, PyList, PyTuple};

use super::convert::{Reduced, numbers};

/// A column of a table.
#[derive(Debug, Clone)]
pub enum Column {
    /// Numbers; NaN if a row has none.
    Numbers(Float64Array),
    /// The different words, and for every row the place of its word.
    Words(Vec<String>, Vec<i32>),
}

impl Column {
    /// A column of numbers. NaN is a missing value.
    pub fn numbers(values: Vec<f64>) -> Self {
        let array = Float64Array::from(values);
        let is_known = array.values().iter().map(|value| !value.is_nan());
        if is_known.clone().all(|known| known) {
            return Self::Numbers(array);
        }
        let known = is_known.collect();
        Self::Numbers(Float64Array::new(array.values().clone(), Some(known)))
    }

    /// A column of words, one for each row.
    pub fn words<'a>(rows: impl Iterator<Item = &'a str>) -> Self {
        let mut words: Vec<String> = Vec::new();
        let codes = rows.map(|word| {
            let place = words.iter().position(|known| known == word).unwrap_or_else(|| {
                words.push(word.to_owned());
                words.len() - 1
            });
            i32::try_from(place).unwrap_or(0)
        });
        let codes = codes.collect();
        Self::Words(words, codes)
    }

    fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.values().len(),
            Self::Words(_, codes) => codes.len(),
        }
    }

    fn array(&self) -> Result<ArrayRef, ArrowError> {
        Ok(match self {
            Self::Numbers(values) => Arc::new(values.clone()),
            Self::Words(words, codes) => Arc::new(DictionaryArray::<Int32Type>::try_new(
                Int32Array::from(codes.clone()),
                Arc::new(StringArray::from(words.clone())),
            )?),
        })
    }

    /// The column as a NumPy array of this shape. Numbers are read-only, because Arrow shares their memory.
    fn numpy<'py>(&self, py: Python<'py>, shape: &[usize]) -> PyResult<Bound<'py, PyAny>> {
        let numpy = py.import("numpy")?;
        let flat = match self {
            Self::Numbers(values) => numpy.call_method1("asarray", (Shared(values.clone()),))?,
            Self::Words(words, codes) => {
                let words = numpy.call_method1("array", (words.clone(), "str"))?;
                words.call_method1("take", (PyArray1::from_slice(py, codes),))?
            }
        };
        flat.call_method1("reshape", (PyTuple::new(py, shape)?,))
    }
}

/// The numbers of a column, which NumPy reads without a copy.
#[pyclass(frozen, module = "plm_impact")]
struct Shared(Float64Array);

#[pymethods]
impl Shared {
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = self.0.values();
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("shape", (values.len(),))?;
        interface.set_item("typestr", if cfg!(target_endian = "little") { "<f8" } else { ">f8" })?;
        // `true` makes the array read-only
        interface.set_item("data", (values.as_ptr().addr(), true))?;
        Ok(interface)
    }
}

/// A table of named columns. `table["restitution"]` is a read-only NumPy array in the shape of the table; `to_dict`
/// returns all columns, `to_pandas` a `pandas.DataFrame`. The table itself is Arrow data, which polars, pyarrow, DuckDB
/// and `pandas.DataFrame.from_arrow` read without a copy. A table can be pickled.
#[pyclass(frozen, mapping, module = "plm_impact")]
#[derive(Debug)]
pub struct Table {
    shape: Vec<usize>,
    columns: Vec<(String, Column)>,
}

impl Table {
    /// A table of these columns, which all have the same number of rows.
    pub fn new(columns: Vec<(String, Column)>) -> Self {
        Self { shape: vec![columns.first().map_or(0, |(_, column)| column.len())], columns }
    }

    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|(known, _)| known == name).map(|(_, column)| column)
    }

    /// A table whose columns have this shape.
    pub fn of_shape(shape: Vec<usize>, columns: Vec<(String, Column)>) -> Self {
        Self { shape, columns }
    }

    fn rows(&self) -> usize {
        self.shape.iter().product()
    }

    fn batch(&self) -> Result<RecordBatch, ArrowError> {
        let arrays = self.columns.iter().map(|(name, column)| Ok((name, column.array()?, true)));
        RecordBatch::try_from_iter_with_nullable(arrays.collect::<Result<Vec<_>, ArrowError>>()?)
    }
}

#[pymethods]
impl Table {
    /// The shape of the columns. In the order of the rows the last index varies fastest.
    #[getter]
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.shape)
    }

    fn __len__(&self) -> usize {
        self.rows()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let missing = || PyKeyError::new_err(format!("no column \"{name}\"; there are {}", self.keys().join(", ")));
        self.column(name).ok_or_else(missing)?.numpy(py, &self.shape)
    }

    fn __contains__(&self, name: &str) -> bool {
        self.column(name).is_some()
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.keys())?.try_iter()
    }

    /// The names of the columns.
    fn keys(&self) -> Vec<String> {
        self.columns.iter().map(|(name, _)| name.clone()).collect()
    }

    fn _ipython_key_completions_(&self) -> Vec<String> {
        self.keys()
    }

    /// All columns as NumPy arrays, by name.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (name, column) in &self.columns {
            dict.set_item(name, column.numpy(py, &self.shape)?)?;
        }
        Ok(dict)
    }

    /// All columns as one structured NumPy array.
    pub fn to_numpy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let dict = self.to_dict(py)?;
        let types = PyList::empty(py);
        for (name, array) in &dict {
            types.append((name, array.getattr("dtype")?))?;
        }
        let whole = py.import("numpy")?.call_method1("empty", (PyTuple::new(py, &self.shape)?, types))?;
        for (name, array) in &dict {
            whole.set_item(name, array)?;
        }
        Ok(whole)
    }

    /// The table as a `pandas.DataFrame`, with a row for each case.
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let missing = |_| PyImportError::new_err("to_pandas needs pandas");
        let frame = py.import("pandas").map_err(missing)?.getattr("DataFrame")?;
        let dict = PyDict::new(py);
        for (name, column) in &self.columns {
            dict.set_item(name, column.numpy(py, &[self.rows()])?)?;
        }
        frame.call1((dict,))
    }

    /// NumPy and `pandas.DataFrame` would make one column of the names.
    #[staticmethod]
    #[pyo3(signature = (*_arguments, **_keywords))]
    fn __array__(_arguments: &Bound<'_, PyTuple>, _keywords: Option<&Bound<'_, PyDict>>) -> PyResult<Py<PyAny>> {
        let ways = "a table has columns: write table.to_numpy() for a structured array, table.to_pandas() for pandas";
        Err(PyTypeError::new_err(ways))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> Reduced<'py, (Vec<usize>, Bound<'py, PyList>)> {
        let columns = PyList::empty(slf.py());
        for (name, column) in &slf.get().columns {
            match column {
                Column::Numbers(_) => columns.append((name, column.numpy(slf.py(), &[slf.get().rows()])?))?,
                Column::Words(words, codes) => columns.append((name, (words, codes)))?,
            }
        }
        Ok((slf.get_type().getattr("_of_columns")?, (slf.get().shape.clone(), columns)))
    }

    #[staticmethod]
    fn _of_columns(shape: Vec<usize>, columns: &Bound<'_, PyList>) -> PyResult<Self> {
        let column = |entry: Bound<'_, PyAny>| {
            let (name, values): (String, Bound<'_, PyAny>) = entry.extract()?;
            Ok(match values.extract::<(Vec<String>, Vec<i32>)>() {
                Ok((words, codes)) => (name, Column::Words(words, codes)),
                Err(_) => (name, Column::numbers(numbers(&values, "column")?.readonly().as_slice()?.to_vec())),
            })
        };
        Ok(Self { shape, columns: columns.iter().map(column).collect::<PyResult<_>>()? })
    }

    /// The table as a `pyarrow.Table`, without a copy of its numbers.
    fn to_arrow<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let missing = |_| {
            PyImportError::new_err(
                "to_arrow needs pyarrow; polars.DataFrame and duckdb take the table itself, and to_pandas gives a DataFrame",
            )
        };
        slf.py().import("pyarrow").map_err(missing)?.call_method1("table", (slf,))
    }

    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // the Arrow standard allows a producer to ignore the requested types
        drop(requested_schema);
        let batch = self.batch().map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        let schema = batch.schema();
        let reader = RecordBatchIterator::new([Ok(batch)], schema);
        PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(reader)), c"arrow_array_stream")
    }

    fn __repr__(&self) -> String {
        let shape = if self.shape.len() == 1 { String::new() } else { format!(" in the shape {:?}", self.shape) };
        format!("<plm_impact.Table: {} rows{shape} of {}>", self.rows(), self.keys().join(", "))
    }
}
