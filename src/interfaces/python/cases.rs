//! Cases that are given as arrays of keys: checks the values, and makes the plan of their table and its rows.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use super::convert::{Numbers, exception, numbers, warn, with_overrides};
use super::rows::{NamedColumns, evaluate, failures, result_columns};
use super::table::value_columns;
use super::workers;
use crate::impact::{self, Method, Solver};
use crate::report::run::table;
use crate::scenario::Scenario;
use crate::scenario::input::{Input, NUMERIC_KEYS, NumericKey};
use crate::scenario::plan::{AxisValues, Cases, Plan, SweepAxis};
use crate::table::RowFailure;
use crate::table::format::arrow;
use crate::table::format::column::TableColumn;
use crate::units::Dimension;

/// The key of the argument `speed`.
pub const SPEED: &str = "impact.speed";

/// A sphere, a half-space and their contact law. The arguments are the tables of a scenario, each as a dict:
///
///     steel = dict(youngs_modulus="210 GPa", poissons_ratio=0.3)
///     contact = Contact(sphere=dict(radius="5 mm", density="7850 kg/m^3", **steel),
///                       half_space=dict(yield_strength="345 MPa", strength_kind="flow", **steel), law="thornton")
///
/// A value is a number in SI units or a text with a unit. All tables and keys of a single impact are allowed, such as
/// damping=dict(viscous=0.05); scenarios/README.md explains them. The speed may be left out, and the law may be a name
/// (see `laws()`) or a table such as dict(plm=dict(unloading_exponent="pressure-shape")).
///
/// A bad key or value raises ValueError, one of a wrong type TypeError; the message has the key, the value and what is
/// allowed. Warnings are ModelWarning, at most one a call. A contact can be pickled, and threads may share it. Two contacts
/// with the same input are equal.
#[pyclass(frozen, name = "Contact", module = "plm_impact")]
#[derive(Debug)]
pub struct PyContact {
    pub scenario: Scenario,
    pub input: Input,
    /// Its bodies and their law.
    pub inner: impact::Contact,
    /// The plans of tables by the keys that vary in them, and whether the smallest value of a key is 0, which may switch
    /// gravity or damping off.
    pub plans: Mutex<HashMap<Vec<(&'static str, bool)>, Plan>>,
}

/// A key and its values in SI units. Numbers may be NaN or out of the allowed range: such a row has no result.
pub struct KeyValues {
    pub key: NumericKey,
    pub numbers: Numbers,
}

impl KeyValues {
    /// A number, an array of numbers, or a text with a unit.
    pub fn new(key: NumericKey, value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let numbers = match value.cast::<PyString>() {
            Ok(text) => {
                let value = key.quantity().parse(&text.to_cow()?).map_err(|text| key_error(key, "", &text))?;
                key.quantity().check(value).map_err(|error| key_error(key, "", &error))?;
                Numbers::scalar(value)
            }
            Err(_) => numbers(value, key.path())?,
        };
        Ok(Self { key, numbers })
    }

    /// Refuses numbers that are not allowed.
    pub fn check(self) -> PyResult<Self> {
        match self.numbers.values.iter().find_map(|value| self.key.quantity().check(*value).err()) {
            Some(error) => Err(key_error(self.key, "", &error)),
            None => Ok(self),
        }
    }

    fn is_allowed(&self, value: f64) -> bool {
        self.key.quantity().check(value).is_ok()
    }

    /// The values of `speed`.
    pub fn speed(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::new(NumericKey::find(SPEED).ok_or_else(|| PyValueError::new_err(SPEED))?, value)
    }

    /// The smallest and the largest of the allowed values, or one where they are the same; none if there are no such values.
    fn value_range(&self) -> Vec<f64> {
        let values = || self.numbers.values.iter().copied().filter(|value| self.is_allowed(*value));
        let mut ends: Vec<f64> =
            values().min_by(f64::total_cmp).into_iter().chain(values().max_by(f64::total_cmp)).collect();
        ends.dedup();
        ends
    }
}

fn key_error(key: NumericKey, place: &str, message: &str) -> PyErr {
    PyValueError::new_err(format!("{}{place}: {message}", key.path()))
}

/// The plan of a table in which these keys vary, each between its smallest and its largest value. It is refused for the
/// same reasons as a scenario with these axes. What does not depend on the values is found once for the same keys.
fn plan(contact: &PyContact, given: &[KeyValues]) -> PyResult<Plan> {
    let ends: Vec<Vec<f64>> = given.iter().map(KeyValues::value_range).collect();
    let keys: Vec<_> =
        given.iter().zip(&ends).map(|(given, ends)| (given.key.path(), ends.first() == Some(&0.0))).collect();
    let mut plans = contact.plans.lock().unwrap_or_else(PoisonError::into_inner);
    let mut plan = if let Some(known) = plans.get(&keys) {
        known.clone()
    } else {
        let axes = given.iter().zip(&ends).map(|(KeyValues { key, .. }, ends)| {
            // an array is in SI; in the text of a scenario an angle carries its unit
            let written = |low: &f64| match key.quantity().dimension {
                Dimension::Angle => format!("\"{low:?} rad\""),
                _ => format!("{low:?}"),
            };
            let value = ends.first().map_or_else(|| key.quantity().example.to_owned(), written);
            format!("sweep.\"{}\"=[{value}]", key.path())
        });
        let scenario = with_overrides(&contact.scenario, axes).map_err(exception)?;
        let plan = scenario.plan().map_err(exception)?;
        plans.insert(keys, plan.clone());
        plan
    };
    if ends.iter().all(|ends| !ends.is_empty()) {
        let axis = |(given, ends): (&KeyValues, Vec<f64>)| SweepAxis::from_numbers(given.key, AxisValues::List(ends));
        plan.cases = Cases::Grid(given.iter().zip(ends).map(axis).collect());
    }
    Ok(plan)
}

/// The paths of all numeric keys, in the order of the registry.
#[pyfunction]
pub fn numeric_keys() -> Vec<&'static str> {
    NUMERIC_KEYS.iter().map(|key| key.path()).collect()
}

/// The values of a numeric key in SI units: a number, or an array in the shape of `value`.
#[pyfunction]
pub fn validated<'py>(contact: &PyContact, path: &str, value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let Some(key) = NumericKey::find(path) else {
        // a scenario refuses it with a suggestion
        let refusal = with_overrides(&contact.scenario, [format!("sweep.{}=[1]", serde_json::Value::from(path))]);
        return Err(refusal.err().map_or_else(|| PyValueError::new_err(path.to_owned()), exception));
    };
    KeyValues::new(key, value)?.numbers.numpy(value.py())
}

/// The columns of a table of impacts, by name. Each key comes with checked values, in arrays of one shape and in the order of
/// the registry. A warning points at the caller of the Python function that calls this one.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)] // what Python hands over
pub fn rows<'py>(
    py: Python<'py>,
    contact: &PyContact,
    keys: Vec<(String, Bound<'py, PyAny>)>,
) -> PyResult<Bound<'py, PyDict>> {
    let given = keys.iter().map(|(path, values)| {
        let key = NumericKey::find(path).ok_or_else(|| PyValueError::new_err(path.clone()))?;
        Ok(KeyValues { key, numbers: numbers(values, path)? })
    });
    let given: Vec<KeyValues> = given.collect::<PyResult<_>>()?;
    let plan = plan(contact, &given)?;
    let count = given.first().map_or(0, |given| given.numbers.values.len());
    let named = result_columns(&plan);
    let (values, mut warnings) = listed_if_allowed(py, contact, &plan, &given, count, &named)?;
    warnings.extend(failures(values.last().map_or(&[], Vec::as_slice)));
    warn(py, 2, &warnings)?;
    value_columns(
        py,
        given.into_iter().map(|KeyValues { key, numbers }| (key.column_name(), numbers.values)),
        named,
        values,
    )
}

/// Why a row without allowed values has no result: its first such value, with its index in the array.
fn not_allowed(given: &[KeyValues], row: usize) -> Option<String> {
    given.iter().find_map(|KeyValues { key, numbers: Numbers { shape, values } }| {
        let error = key.quantity().check(*values.get(row)?).err()?;
        let mut rest = row;
        let mut indices: Vec<String> = Vec::new();
        for length in shape.iter().rev() {
            indices.insert(0, (rest % length.max(&1)).to_string());
            rest /= length.max(&1);
        }
        let place = match &indices[..] {
            [] => String::new(),
            [index] => format!(" at index {index}"),
            _ => format!(" at index ({})", indices.join(", ")),
        };
        Some(format!("{}{place}: {error}", key.path()))
    })
}

/// The columns of [`evaluate`], and the warnings. Rows with a value that is not allowed have NaN, and the status says so.
fn listed_if_allowed(
    py: Python<'_>,
    contact: &PyContact,
    plan: &Plan,
    given: &[KeyValues],
    count: usize,
    named: &NamedColumns,
) -> PyResult<(Vec<Vec<f64>>, Vec<String>)> {
    let is_allowed = |row: &usize| given.iter().all(|given| given.is_allowed(given.numbers.values[*row]));
    let allowed: Vec<usize> = (0..count).filter(is_allowed).collect();
    let mut warnings = if allowed.is_empty() {
        Vec::new()
    } else {
        py.detach(|| table::warnings_of_table(plan, Some(&contact.inner)))
    };
    if allowed.len() == count {
        let keys: Vec<_> = given.iter().map(|given| (given.key, given.numbers.values.as_slice())).collect();
        return Ok((evaluate(py, plan, &contact.inner, &keys, count, named)?, warnings));
    }
    warnings.extend((0..count).find(|row| !is_allowed(row)).and_then(|row| not_allowed(given, row)));
    let values = |given: &KeyValues| allowed.iter().map(|row| given.numbers.values[*row]).collect();
    let kept: Vec<Vec<f64>> = given.iter().map(values).collect();
    let keys: Vec<_> = given.iter().zip(&kept).map(|(given, values)| (given.key, values.as_slice())).collect();
    let computed = evaluate(py, plan, &contact.inner, &keys, allowed.len(), named)?;
    let status = arrow::failure_code(RowFailure::NotAllowed);
    let empty = named.iter().map(|(_, column)| if matches!(column, TableColumn::Status) { status } else { f64::NAN });
    let columns = computed.into_iter().zip(empty).map(|(column, empty)| {
        let mut all = vec![empty; count];
        allowed.iter().zip(column).for_each(|(row, value)| all[*row] = value);
        all
    });
    Ok((columns.collect(), warnings))
}

/// Restitution at these speeds, in an array of their shape, or as a number for one speed.
pub fn restitution<'py>(contact: &PyContact, speed: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = speed.py();
    let given = [KeyValues::speed(speed)?];
    let plan = plan(contact, &given)?;
    let speeds = &given[0].numbers.values;
    let mut warnings = Vec::new();
    let forces = plan.input.forces();
    let is_exact = forces.is_none() && plan.input.solver().method.resolve(&forces, false) == Some(Method::ClosedForm);
    let computed = if is_exact {
        // friction does not change e
        let restitution_at = |speed: &f64| {
            if !given[0].is_allowed(*speed) {
                return (f64::NAN, arrow::failure_code(RowFailure::NotAllowed));
            }
            let normal_speed = contact.input.approach_at(*speed).normal;
            match contact.inner.row(normal_speed, &Solver::AUTO) {
                Ok(row) => (row.restitution, 0.0),
                Err(error) => (f64::NAN, arrow::failure_code(error.into())),
            }
        };
        if speeds.iter().any(|speed| given[0].is_allowed(*speed)) {
            warnings = py.detach(|| table::warnings_of_table(&plan, Some(&contact.inner)));
        }
        warnings.extend((0..speeds.len()).find_map(|row| not_allowed(&given, row)));
        workers::columns(py, speeds.len(), &[1, 1], false, |cases| {
            let (restitutions, status): (Vec<f64>, Vec<f64>) = speeds[cases].iter().map(restitution_at).unzip();
            Ok(vec![restitutions, status])
        })?
    } else {
        let mut named = result_columns(&plan);
        named.retain(|(name, _)| ["restitution", "status"].contains(&name.as_str()));
        let (values, of_table) = listed_if_allowed(py, contact, &plan, &given, speeds.len(), &named)?;
        warnings = of_table;
        values
    };
    let [restitutions, status]: [Vec<f64>; 2] = computed.try_into().unwrap_or_default();
    warnings.extend(failures(&status));
    warn(py, 1, &warnings)?;
    let [KeyValues { numbers: Numbers { shape, .. }, .. }] = given;
    Numbers { shape, values: restitutions }.numpy(py)
}
