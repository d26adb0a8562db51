//! Conversions between Python and the library: dicts to scenarios, JSON to objects, errors to exceptions, warnings.

use std::ffi::CString;

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods as _, PyUntypedArrayMethods as _};
use pyo3::exceptions::{PyOverflowError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBytes, PyFloat, PyInt, PyMapping, PyType};
use serde_json::Value;

use crate::error::{Details, Error};
use crate::scenario::{Scenario, ScenarioSource};

/// The return value of `__reduce__`, by which Python pickles an object: a function, and the arguments with which this function
/// makes the object again.
pub type Reduced<'py, Arguments> = PyResult<(Bound<'py, PyAny>, Arguments)>;

/// A function of `plm_impact._convert`.
pub fn helper<'py>(py: Python<'py>, function: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("plm_impact._convert")?.getattr(function)
}

/// The HTML by which a notebook shows an object: its text, and a picture.
pub fn html<'py>(shown: &Bound<'py, PyAny>, picture: Option<Bound<'py, PyBytes>>) -> PyResult<Bound<'py, PyAny>> {
    shown.py().import("plm_impact._results")?.call_method1("html_of", (shown.repr()?, picture))
}

/// A scenario that is given as a dict.
pub fn source_of(tables: &Bound<'_, PyMapping>) -> PyResult<ScenarioSource> {
    let (text, overrides) = helper(tables.py(), "scenario_of")?.call1((tables,))?.extract()?;
    Ok(ScenarioSource { text, overrides, ..ScenarioSource::default() })
}

/// `key=value` for every entry of `set`.
pub fn overrides(set: Option<&Bound<'_, PyMapping>>) -> PyResult<Vec<String>> {
    let Some(set) = set else { return Ok(Vec::new()) };
    let toml = helper(set.py(), "toml")?;
    let text = |pair: Bound<'_, PyAny>| {
        let (key, value): (String, Bound<'_, PyAny>) = pair.extract()?;
        Ok(format!("{key}={}", toml.call1((value, &key))?))
    };
    set.items()?.iter().map(text).collect()
}

/// Numbers in SI units, and the shape of their array; none for a plain number.
pub struct Numbers {
    pub shape: Vec<usize>,
    pub values: Vec<f64>,
}

impl Numbers {
    pub fn scalar(value: f64) -> Self {
        Self { shape: Vec::new(), values: vec![value] }
    }

    /// A NumPy array, or a plain number.
    pub fn numpy(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        match self.values[..] {
            [value] if self.shape.is_empty() => Ok(value.into_pyobject(py)?.into_any()),
            _ => Ok(PyArray1::from_vec(py, self.values).reshape(self.shape)?.into_any()),
        }
    }
}

/// The numbers of an array, or of what NumPy takes for one. Messages use `place`, the name of the numbers.
pub fn numbers(value: &Bound<'_, PyAny>, place: &str) -> PyResult<Numbers> {
    static FLOAT64: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    // other subclasses of a float may have a unit
    let is_plain = || Ok::<_, PyErr>(value.get_type().is(FLOAT64.import(value.py(), "numpy", "float64")?));
    if value.is_exact_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>() || is_plain()? {
        let number = value.extract::<f64>();
        if number.as_ref().is_err_and(|error| error.is_instance_of::<PyOverflowError>(value.py())) {
            return Err(PyValueError::new_err(format!("{place}: the whole number is too large")));
        }
        return Ok(Numbers::scalar(number?));
    }
    // as it comes from NumPy; a subclass may have units or a mask, and data from another process may not be aligned
    let array = match value.cast_exact::<PyArrayDyn<f64>>() {
        Ok(array) if array.is_c_contiguous() && array.data().is_aligned() => array.clone(),
        _ => helper(value.py(), "numbers")?.call1((value, place))?.cast_into()?,
    };
    Ok(Numbers { shape: array.shape().to_vec(), values: array.readonly().as_slice()?.to_vec() })
}

/// JSON as Python objects.
pub fn from_json<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (value.to_string(),))
}

/// The exception of a scenario that cannot be read; for a missing file it is a `FileNotFoundError` too.
pub fn unreadable_exception(py: Python<'_>, error: Error) -> PyErr {
    static NOT_FOUND_ERROR: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let (true, Some(reason), Some(file)) = (error.is_not_found(), &error.io_error, &error.details.file) else {
        return exception(error);
    };
    // the words that Python itself has for it
    let class = || {
        let words = py.import("os")?.call_method1("strerror", (reason.raw_os_error(),))?.unbind();
        let class = NOT_FOUND_ERROR.import(py, "plm_impact", "ScenarioNotFoundError")?;
        Ok(PyErr::from_type(class.clone(), (reason.raw_os_error(), words, file.clone())))
    };
    class().unwrap_or_else(|failed: PyErr| failed)
}

/// The exception of an error: `ValueError` if the input has to change, `RuntimeError` if a run failed.
pub fn exception(error: impl Into<Error>) -> PyErr {
    let error = error.into();
    let Details { file, key, message, .. } = &*error.details;
    if let (None, Some(key), Some(message)) = (file, key, message) {
        // the key is an argument here, so the message must not name the option --set
        return PyValueError::new_err(format!("{}: {message}", key.strip_prefix("sweep.").unwrap_or(key)));
    }
    if error.exit_code() == 2 {
        PyValueError::new_err(error.to_string())
    } else {
        PyRuntimeError::new_err(error.to_string())
    }
}

/// A scenario with `key=value` set.
pub fn with_overrides(scenario: &Scenario, overrides: impl IntoIterator<Item = String>) -> Result<Scenario, Error> {
    let mut source = scenario.source();
    source.overrides.extend(overrides);
    Scenario::from_source(scenario.document.name(), &source)
}

/// Issues one `ModelWarning` with these texts, if there are any. It points at the caller `level` frames of Python above.
pub fn warn(py: Python<'_>, level: i32, warnings: &[String]) -> PyResult<()> {
    static MODEL_WARNING: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    if warnings.is_empty() {
        return Ok(());
    }
    let text = CString::new(warnings.join("\n").replace('\0', " "))?;
    PyErr::warn(py, MODEL_WARNING.import(py, "plm_impact", "ModelWarning")?, &text, level)
}

#[allow(clippy::needless_pass_by_value)] // for map_err
pub(super) fn json_error(error: serde_json::Error) -> PyErr {
    PyValueError::new_err(error.to_string())
}
