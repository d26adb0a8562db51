//! Conversions between Python and the library: dicts to scenarios, JSON to objects, errors to exceptions, warnings.

use std::ffi::CString;
use std::fmt::Write as _;

use numpy::PyArrayDyn;
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyUserWarning, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use serde_json::Value;

use crate::error::{Details, Error};
use crate::scenario::{Scenario, ScenarioError};

/// Largest depth of dicts and lists inside of each other; no scenario needs as much.
const DEEPEST: usize = 16;

/// The TOML text of a scenario that is given as a dict. The tables and their keys keep the order of the dict.
pub fn scenario_text(tables: &Bound<'_, PyDict>) -> PyResult<String> {
    let (mut text, mut rest) = (String::new(), String::new());
    for (name, value) in tables {
        let name = key(&name)?;
        match toml_value(&value, &name, 0)? {
            toml::Value::Table(table) => {
                let _ = writeln!(rest, "[{name}]");
                for (inner, value) in table {
                    let _ = writeln!(rest, "{} = {value}", quoted(&inner));
                }
            }
            // plain keys come before the tables; after a table they would belong to it
            plain => drop(writeln!(text, "{name} = {plain}")),
        }
    }
    Ok(text + &rest)
}

/// The name of a key in TOML.
fn key(name: &Bound<'_, PyAny>) -> PyResult<String> {
    let text = name.extract::<String>().map_err(|_| PyTypeError::new_err(format!("a key is a text, not {name}")))?;
    Ok(quoted(&text))
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
    if let Ok(dict) = value.cast::<PyDict>() {
        let mut table = toml::Table::new();
        for (name, inner) in dict {
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
    refuse_lost(value, place)?;
    let numpy = value.py().import("numpy")?;
    let array = numpy.call_method1("asarray", (value,))?;
    let dtype = array.getattr("dtype")?;
    if !["i", "u", "f"].contains(&dtype.getattr("kind")?.extract::<String>()?.as_str()) {
        return Err(PyTypeError::new_err(format!("{place}: found the type {dtype}, expected numbers in SI")));
    }
    // arrays from another process may not be aligned in memory
    Ok(numpy.call_method1("require", (array, "float64", ["C", "A"]))?.cast_into::<PyArrayDyn<f64>>()?)
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
    Ok(match value {
        Value::Null => py.None().into_bound(py),
        Value::Bool(word) => PyBool::new(py, *word).to_owned().into_any(),
        Value::Number(number) => match number.as_u64() {
            Some(number) => number.into_pyobject(py)?.into_any(),
            None => number.as_f64().unwrap_or(f64::NAN).into_pyobject(py)?.into_any(),
        },
        Value::String(text) => PyString::new(py, text).into_any(),
        Value::Array(items) => {
            let items = items.iter().map(|item| from_json(py, item)).collect::<PyResult<Vec<_>>>()?;
            PyList::new(py, items)?.into_any()
        }
        Value::Object(map) => {
            let dict = PyDict::new(py);
            for (name, inner) in map {
                dict.set_item(name, from_json(py, inner)?)?;
            }
            dict.into_any()
        }
    })
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
pub fn with(scenario: &Scenario, overrides: impl IntoIterator<Item = String>) -> Result<Scenario, ScenarioError> {
    let mut source = scenario.source()?;
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
