//! Conversions between Python and the library: dicts to scenarios, JSON to objects, errors to exceptions, warnings.

use std::ffi::CString;
use std::fmt::Write as _;

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods as _, PyUntypedArrayMethods as _};
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyUserWarning, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBool, PyFloat, PyInt, PyList, PyMapping, PyString, PyTuple, PyType};
use serde_json::Value;

use crate::error::{Details, Error};
use crate::plan::Source;
use crate::scenario::Scenario;

/// What `__reduce__` returns: a function, and the arguments with which it makes the object anew.
pub type Reduced<'py, Arguments> = PyResult<(Bound<'py, PyAny>, Arguments)>;

/// Largest depth of dicts and lists inside of each other; no scenario needs as much.
const DEEPEST: usize = 16;

/// A scenario that is given as a dict: its TOML text, in which tables and keys keep the order of the dict. A law that is
/// given by its name alone becomes an override, which is where a scenario takes names of laws.
pub fn source_of(tables: &Bound<'_, PyMapping>) -> PyResult<Source> {
    let (mut text, mut rest, mut overrides) = (String::new(), String::new(), Vec::new());
    for (name, value) in items(tables)? {
        let name = name.extract::<String>();
        let name = quoted(&name.map_err(|_| PyTypeError::new_err("a key is a text, and one of these is none"))?);
        match toml_value(&value, &name, 0)? {
            toml::Value::Table(table) => {
                let _ = writeln!(rest, "[{name}]");
                for (inner, value) in table {
                    let _ = writeln!(rest, "{} = {value}", quoted(&inner));
                }
            }
            law @ toml::Value::String(_) if name == "law" => overrides.push(format!("law={law}")),
            // plain keys come before the tables; after a table they would belong to it
            plain => drop(writeln!(text, "{name} = {plain}")),
        }
    }
    Ok(Source { text: text + &rest, overrides, ..Source::default() })
}

/// `key=value` for every entry of `set`.
pub fn overrides(set: Option<&Bound<'_, PyMapping>>) -> PyResult<Vec<String>> {
    let entries = set.map(items).transpose()?.unwrap_or_default();
    let text = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let key: String = key.extract()?;
        Ok(format!("{key}={}", toml_value(&value, &key, 0)?))
    };
    entries.into_iter().map(text).collect()
}

/// Keys and values of a dict, or of another mapping.
fn items<'py>(mapping: &Bound<'py, PyMapping>) -> PyResult<Vec<(Bound<'py, PyAny>, Bound<'py, PyAny>)>> {
    mapping.items()?.iter().map(|pair| pair.extract()).collect()
}

fn quoted(name: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.chars().all(is_bare) { name.to_owned() } else { Value::from(name).to_string() }
}

/// A value of a dict in TOML. Messages use `place`, the path of its key.
pub fn toml_value(value: &Bound<'_, PyAny>, place: &str, depth: usize) -> PyResult<toml::Value> {
    if depth > DEEPEST {
        return Err(PyValueError::new_err(format!("{place}: too many dicts or lists inside of each other")));
    }
    let found = |what: &str| PyTypeError::new_err(format!("{place}: {what}"));
    if value.is_none() {
        return Err(found("found None; leave the key out"));
    }
    refuse_lost(value, place)?;
    if value.is_instance_of::<PyBool>() {
        return Ok(toml::Value::Boolean(value.extract()?));
    }
    if value.is_instance_of::<PyInt>() {
        let number = value.extract::<i64>().map_err(|_| found("the whole number is too large; write it as a float"))?;
        return Ok(toml::Value::Integer(number));
    }
    if value.is_instance_of::<PyFloat>() {
        return Ok(toml::Value::Float(value.extract()?));
    }
    if value.is_instance_of::<PyString>() {
        return Ok(toml::Value::String(value.extract()?));
    }
    if let Ok(mapping) = value.cast::<PyMapping>() {
        let mut table = toml::Table::new();
        for (name, inner) in items(mapping)? {
            let name: String = name.extract().map_err(|_| found("a key is not a text"))?;
            let inner = toml_value(&inner, &format!("{place}.{name}"), depth + 1)?;
            table.insert(name, inner);
        }
        return Ok(toml::Value::Table(table));
    }
    if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        let items = value.try_iter()?.map(|item| toml_value(&item?, place, depth + 1));
        return Ok(toml::Value::Array(items.collect::<PyResult<_>>()?));
    }
    if value.hasattr("__fspath__")? {
        return toml_value(&value.call_method0("__fspath__")?, place, depth + 1);
    }
    if value.hasattr("tolist")? {
        return toml_value(&value.call_method0("tolist")?, place, depth + 1);
    }
    Err(found(&format!("found {}, expected a number, a text, a list or a dict", value.get_type().name()?)))
}

/// Numbers in SI units as a contiguous NumPy array of doubles. Messages use `place`, the name of the numbers.
pub fn numbers<'py>(value: &Bound<'py, PyAny>, place: &str) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    static ASARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    static REQUIRE: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    // as it comes from NumPy; a subclass may have units or a mask, and data from another process may not be aligned
    if let Ok(array) = value.cast_exact::<PyArrayDyn<f64>>()
        && array.is_c_contiguous()
        && array.data().is_aligned()
    {
        return Ok(array.clone());
    }
    let py = value.py();
    refuse_lost(value, place)?;
    let array = ASARRAY.import(py, "numpy", "asarray")?.call1((value,))?;
    let dtype = array.getattr("dtype")?;
    if !["i", "u", "f"].contains(&dtype.getattr("kind")?.extract::<String>()?.as_str()) {
        return Err(PyTypeError::new_err(format!("{place}: found the type {dtype}, expected numbers in SI")));
    }
    Ok(REQUIRE.import(py, "numpy", "require")?.call1((array, "float64", ["C", "A"]))?.cast_into::<PyArrayDyn<f64>>()?)
}

/// A NumPy array of this shape that takes over the numbers.
pub fn shaped<'py>(py: Python<'py>, numbers: Vec<f64>, shape: &[usize]) -> PyResult<Bound<'py, PyAny>> {
    let array = PyArray1::from_vec(py, numbers);
    if shape.len() == 1 { Ok(array.into_any()) } else { Ok(array.reshape(shape.to_vec())?.into_any()) }
}

/// Refuses arrays with units and masked arrays, because NumPy would drop units and mask without a warning.
pub fn refuse_lost(value: &Bound<'_, PyAny>, place: &str) -> PyResult<()> {
    for (name, what) in [
        ("units", "a unit of its own; give plain numbers in SI, or a text such as \"5 mm\""),
        ("unit", "a unit of its own; give plain numbers in SI, or a text such as \"5 mm\""),
        ("mask", "a mask; leave the masked values out"),
    ] {
        if value.hasattr(name)? && !value.getattr(name)?.is_callable() {
            return Err(PyTypeError::new_err(format!("{place}: the value has {what}")));
        }
    }
    Ok(())
}

/// JSON as Python objects.
pub fn from_json<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (value.to_string(),))
}

/// The exception of a scenario that cannot be read; for a missing file it is a `FileNotFoundError` too.
pub fn unreadable(py: Python<'_>, error: Error) -> PyErr {
    static NO_SUCH_FILE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let (true, Some(reason), Some(file)) = (error.is_not_found(), &error.reason, &error.details.file) else {
        return exception(error);
    };
    let arguments = (reason.raw_os_error(), format!("cannot be read: {reason}"), file.clone());
    let class = NO_SUCH_FILE.import(py, "plm_impact", "NoSuchFile");
    class.map_or_else(|failed| failed, |class| PyErr::from_type(class.clone(), arguments))
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
pub fn with(scenario: &Scenario, overrides: impl IntoIterator<Item = String>) -> Result<Scenario, Error> {
    let mut source = scenario.source();
    source.overrides.extend(overrides);
    Scenario::from_source(scenario.document.name(), &source)
}

/// Issues Python warnings.
pub fn warn<'a>(py: Python<'_>, warnings: impl IntoIterator<Item = &'a String>) -> PyResult<()> {
    for warning in warnings {
        let text = CString::new(warning.replace('\0', " "))?;
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), &text, 1)?;
    }
    Ok(())
}
