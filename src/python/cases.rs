//! Cases that are given as arrays of keys: finds the keys, checks the values, and makes the plan of their table.

use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods as _, PyReadonlyArrayDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString, PyTuple};
use rayon::prelude::*;

use super::convert::{exception, numbers, warn, with};
use super::rows::{self, code, say_failures};
use super::table::{Column, Table};
use super::work::{TOGETHER, interruptible};
use crate::impact::{self, Method};
use crate::plan::axis::{Axis, Values};
use crate::plan::{Cases, Plan};
use crate::run::table::warnings;
use crate::scenario::Scenario;
use crate::scene::{KEYS, Key};

/// A key and its values in SI units, all of them in the allowed range.
struct Given<'py> {
    key: &'static Key,
    array: PyReadonlyArrayDyn<'py, f64>,
    /// The smallest and the largest value; `None` if there are no values.
    ends: Option<[f64; 2]>,
}

impl<'py> Given<'py> {
    fn new(key: &'static Key, value: &Bound<'py, PyAny>) -> PyResult<Self> {
        let array = match value.cast::<PyString>() {
            Ok(text) => {
                let number = key.quantity.parse(&text.to_cow()?).map_err(|message| refused(key, "", &message))?;
                numbers(&number.into_pyobject(value.py())?.into_any(), key.path)?
            }
            Err(_) => numbers(value, key.path)?,
        };
        let array = array.readonly();
        let mut given = Self { key, array, ends: None };
        given.check()?;
        Ok(given)
    }

    fn values(&self) -> PyResult<&[f64]> {
        Ok(self.array.as_slice()?)
    }

    /// Finds the smallest and the largest value, and refuses values out of range.
    fn check(&mut self) -> PyResult<()> {
        let values = self.values()?;
        let Some(first) = values.first() else { return Ok(()) };
        let (mut low, mut high, mut is_known) = (*first, *first, true);
        for value in values {
            low = if *value < low { *value } else { low };
            high = if *value > high { *value } else { high };
            is_known &= !value.is_nan();
        }
        let quantity = self.key.quantity;
        if !is_known || quantity.check(low).is_err() || quantity.check(high).is_err() {
            for (index, value) in values.iter().enumerate() {
                let place = if values.len() == 1 { String::new() } else { format!(" at index {index}") };
                quantity.check(*value).map_err(|error| refused(self.key, &place, &error.to_string()))?;
            }
        }
        self.ends = Some([low, high]);
        Ok(())
    }
}

fn refused(key: &Key, place: &str, message: &str) -> PyErr {
    PyValueError::new_err(format!("{}{place}: {message}", key.path))
}

/// The plan of a table in which these keys vary, each between its smallest and its largest value. It is refused for the
/// same reasons as a scenario with these axes.
fn plan(scenario: &Scenario, given: &[&Given]) -> PyResult<Plan> {
    let overrides = given.iter().map(|given| {
        let value = given.ends.map_or_else(|| given.key.quantity.example.to_owned(), |[low, _]| format!("{low:?}"));
        format!("sweep.\"{}\"=[{value}]", given.key.path)
    });
    let scenario = with(scenario, overrides).map_err(exception)?;
    let mut plan = crate::run::table::plan(&scenario).map_err(exception)?;
    let axes = given.iter().map(|given| {
        let values =
            given.ends.map_or_else(Vec::new, |[low, high]| if low < high { vec![low, high] } else { vec![low] });
        Axis::of_number(given.key, Values::List(values))
    });
    if given.iter().all(|given| given.ends.is_some()) {
        plan.cases = Cases::Grid(axes.collect());
    }
    Ok(plan)
}

/// The numeric keys that the name of an argument may mean. For `impact.speed` the names are `impact.speed`,
/// `impact_speed` and `speed`.
fn meant(name: &str) -> Vec<&'static Key> {
    let whole = KEYS.iter().find(|key| key.path == name || key.path.replace('.', "_") == name);
    let last = KEYS.iter().filter(|key| key.path.rsplit('.').next() == Some(name));
    whole.map_or_else(|| last.collect(), |key| vec![key])
}

/// The arguments with their keys. If a name fits several keys, the key is used that the scenario allows to vary.
fn keys<'py>(scenario: &Scenario, arguments: &Bound<'py, PyDict>) -> PyResult<Vec<Given<'py>>> {
    let mut clear = Vec::new();
    let mut unclear = Vec::new();
    for (name, value) in arguments {
        let name: String = name.extract()?;
        match meant(&name)[..] {
            [] => {
                let refusal = with(scenario, [format!("sweep.{}=[1]", serde_json::Value::from(name.as_str()))]);
                return Err(refusal.err().map_or_else(|| PyValueError::new_err(name), exception));
            }
            [key] => clear.push(Given::new(key, &value)?),
            ref keys => unclear.push((name, keys.to_vec(), value)),
        }
    }
    let mut found = Vec::new();
    for (name, candidates, value) in unclear {
        let mut fits = Vec::new();
        let mut refusal = None;
        for key in candidates {
            let tried = Given::new(key, &value).and_then(|one| {
                plan(scenario, &clear.iter().chain([&one]).collect::<Vec<_>>())?;
                Ok(one)
            });
            match tried {
                Ok(one) => fits.push(one),
                Err(error) => refusal = Some(error),
            }
        }
        if fits.len() > 1 {
            let names: Vec<_> = fits.iter().map(|given| given.key.path.replace('.', "_")).collect();
            return Err(PyValueError::new_err(format!("{name}: may be {}; write one of them", names.join(" or "))));
        }
        found.extend(fits.pop().map_or_else(|| refusal.map_or(Ok(None), Err), |given| Ok(Some(given)))?);
    }
    clear.extend(found);
    // the order of the registry, so that results do not depend on the order of the arguments
    clear.sort_by_key(|given| KEYS.iter().position(|key| key.path == given.key.path));
    Ok(clear)
}

/// The table of impacts with these keys, broadcast against each other.
pub fn impacts(scenario: &Scenario, arguments: &Bound<'_, PyDict>) -> PyResult<Table> {
    let py = arguments.py();
    let given = keys(scenario, arguments)?;
    let plan = plan(scenario, &given.iter().collect::<Vec<_>>())?;
    let numpy = py.import("numpy")?;
    let arrays =
        numpy.call_method1("broadcast_arrays", PyTuple::new(py, given.iter().map(|given| (*given.array).clone()))?)?;
    let mut shape = Vec::new();
    let mut columns = Vec::new();
    for array in arrays.try_iter()? {
        let array = array?;
        shape = array.getattr("shape")?.extract()?;
        let array = numpy.call_method1("asarray", (array, "float64", "C"))?.cast_into::<PyArrayDyn<f64>>()?;
        columns.push(array.readonly().as_slice()?.to_vec());
    }
    let count = shape.iter().product();
    if count > 0 {
        warn(py, &py.detach(|| warnings(&plan)))?;
    }
    let listed: Vec<_> = given.iter().zip(&columns).map(|(given, values)| (given.key, values.as_slice())).collect();
    let made = rows::listed(py, &plan, &listed, count, &plan.results())?;
    say_failures(py, count, made.status.iter().copied())?;
    Ok(Table::of_shape(shape, made.table(&plan, columns.into_iter().map(Column::numbers).collect())))
}

/// Restitution at these speeds, in an array of their shape, or as a number for one speed.
pub fn restitution<'py>(
    scenario: &Scenario,
    key: &'static Key,
    speed: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = speed.py();
    let given = Given::new(key, speed)?;
    let plan = plan(scenario, &[&given])?;
    let speeds = given.values()?;
    if !speeds.is_empty() {
        warn(py, &py.detach(|| warnings(&plan)))?;
    }
    let is_exact = plan.scene.forces.is_none() && matches!(plan.scene.solver.method, Method::Auto | Method::ClosedForm);
    let restitutions = if is_exact {
        let contact = plan.scene.contact().map_err(|reason| PyValueError::new_err(reason.to_string()))?;
        let restitutions = interruptible(py, |is_cancelled| exact(&contact, speeds, is_cancelled))?;
        let failed = restitutions.iter().zip(speeds).filter(|(restitution, _)| restitution.is_nan());
        let status = |speed: &f64| contact.restitution(*speed).err().map_or(0, |error| code(error.into()));
        say_failures(py, speeds.len(), failed.map(|(_, speed)| status(speed)))?;
        restitutions
    } else {
        let columns: Vec<_> = plan.results().into_iter().filter(|column| column.name == "restitution").collect();
        let mut made = rows::listed(py, &plan, &[(key, speeds)], speeds.len(), &columns)?;
        say_failures(py, speeds.len(), made.status.into_iter())?;
        made.columns.pop().unwrap_or_default()
    };
    let shape = given.array.getattr("shape")?;
    let array = PyArray1::from_vec(py, restitutions).call_method1("reshape", (&shape,))?;
    if shape.len()? == 0 { array.call_method0("item") } else { Ok(array) }
}

/// Restitution in closed form; NaN for a speed without a result.
fn exact(contact: &impact::Contact, speeds: &[f64], is_cancelled: &AtomicBool) -> Vec<f64> {
    let mut restitutions = vec![0.0; speeds.len()];
    let pieces = restitutions.par_chunks_mut(TOGETHER).zip(speeds.par_chunks(TOGETHER));
    pieces.for_each(|(restitutions, speeds)| {
        if is_cancelled.load(Ordering::Relaxed) {
            return;
        }
        for (restitution, speed) in restitutions.iter_mut().zip(speeds) {
            *restitution = contact.restitution(*speed).unwrap_or(f64::NAN);
        }
    });
    restitutions
}
