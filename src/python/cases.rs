//! Cases that are given as arrays of keys: finds the keys, checks the values, and makes the plan of their table.

use std::slice;
use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};

use numpy::{PyArrayDyn, PyArrayMethods as _, PyReadonlyArrayDyn, PyUntypedArrayMethods as _};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyString, PyTuple};
use rayon::prelude::*;

use super::convert::{exception, numbers, shaped, warn, with};
use super::rows::{self, code, say_failures};
use super::table::{Column, Table};
use super::work::{FEW, TOGETHER, interruptible};
use crate::impact::{self, Method};
use crate::plan::axis::{Axis, Values};
use crate::plan::{Cases, Plan};
use crate::run::table::warnings_of;
use crate::scenario::Scenario;
use crate::scene::{KEYS, Key, Scene};
use crate::units::Dimension;

/// The key of the argument `speed`.
pub const SPEED: &str = "impact.speed";

/// The plans of tables by the keys that vary in them, and whether the smallest value of a key is 0.
pub type Plans = Mutex<Vec<(Vec<(&'static str, bool)>, Plan)>>;

/// The data of a contact.
#[derive(Debug)]
pub struct Inner {
    pub scenario: Scenario,
    pub scene: Scene,
    pub contact: impact::Contact,
    pub plans: Plans,
}

/// A key and its values in SI units, all of them in the allowed range.
pub struct Given<'py> {
    pub key: &'static Key,
    numbers: Numbers<'py>,
    /// The smallest and the largest value; `None` if there are no values.
    ends: Option<[f64; 2]>,
}

enum Numbers<'py> {
    One(f64),
    Array(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py> Given<'py> {
    /// A number, an array of numbers, or a text with a unit.
    pub fn new(key: &'static Key, value: &Bound<'py, PyAny>) -> PyResult<Self> {
        let numbers = if let Ok(text) = value.cast::<PyString>() {
            Numbers::One(key.quantity.parse(&text.to_cow()?).map_err(|message| refused(key, "", &message))?)
        } else if value.cast_exact::<PyFloat>().is_ok() || value.cast_exact::<PyInt>().is_ok() {
            Numbers::One(value.extract()?)
        } else {
            Numbers::Array(numbers(value, key.path)?.readonly())
        };
        let mut given = Self { key, numbers, ends: None };
        given.check()?;
        Ok(given)
    }

    fn values(&self) -> PyResult<&[f64]> {
        Ok(match &self.numbers {
            Numbers::One(value) => slice::from_ref(value),
            Numbers::Array(array) => array.as_slice()?,
        })
    }

    fn shape(&self) -> &[usize] {
        match &self.numbers {
            Numbers::One(_) => &[],
            Numbers::Array(array) => array.shape(),
        }
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
                quantity.check(*value).map_err(|error| refused(self.key, &place, &error))?;
            }
        }
        self.ends = Some([low, high]);
        Ok(())
    }
}

pub fn refused(key: &Key, place: &str, message: &str) -> PyErr {
    PyValueError::new_err(format!("{}{place}: {message}", key.path))
}

/// The plan of a table in which these keys vary, each between its smallest and its largest value. It is refused for the
/// same reasons as a scenario with these axes. What does not depend on the values is found once for the same keys, and
/// [`keep`] keeps it for the next call; a value of 0 may switch gravity or damping off.
fn plan(contact: &Inner, given: &[Given]) -> PyResult<Plan> {
    let keys = varied(given);
    let mut plans = contact.plans.lock().unwrap_or_else(PoisonError::into_inner);
    let known = plans.iter().position(|(known, _)| *known == keys);
    let mut plan = if let Some(place) = known {
        plans.swap_remove(place).1
    } else {
        let axes = given.iter().map(|Given { key, ends, .. }| {
            // an array is in SI; in the text of a scenario an angle carries its unit
            let written = |low: f64| match key.quantity.dimension {
                Dimension::Angle => format!("\"{low:?} rad\""),
                _ => format!("{low:?}"),
            };
            let value = ends.map_or_else(|| key.quantity.example.to_owned(), |[low, _]| written(low));
            format!("sweep.\"{}\"=[{value}]", key.path)
        });
        let scenario = with(&contact.scenario, axes).map_err(exception)?;
        crate::run::table::plan(&scenario).map_err(exception)?
    };
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

/// The keys that vary, and whether the smallest value of each is 0.
fn varied(given: &[Given]) -> Vec<(&'static str, bool)> {
    given.iter().map(|given| (given.key.path, given.ends.is_some_and(|[low, _]| low == 0.0))).collect()
}

/// Keeps a plan for the next call with the same keys.
fn keep(contact: &Inner, given: &[Given], plan: Plan) {
    let mut plans = contact.plans.lock().unwrap_or_else(PoisonError::into_inner);
    let keys = varied(given);
    if plans.iter().all(|(known, _)| *known != keys) {
        plans.push((keys, plan));
    }
}

/// The numeric keys that the name of an argument may mean. For `impact.speed` the names are `impact.speed`,
/// `impact_speed` and `speed`. The last part alone does not mean keys of other laws than that of the contact, nor the
/// strength of the sphere, which changes no table.
fn meant(contact: &Inner, name: &str) -> Vec<&'static Key> {
    let letters = |path: &str| path.bytes().map(|letter| if letter == b'.' { b'_' } else { letter }).eq(name.bytes());
    if let Some(whole) = KEYS.iter().find(|key| key.path == name || letters(key.path)) {
        return vec![whole];
    }
    let ends = |path: &str| path.strip_suffix(name).is_some_and(|head| head.ends_with('.'));
    let last: Vec<_> = KEYS.iter().filter(|key| ends(key.path)).collect();
    let own = format!("law.{}.", contact.scene.law.about().name);
    let is_idle = |path: &str| path == "sphere.yield_strength" || path.starts_with("law.") && !path.starts_with(&own);
    let kept: Vec<_> = last.iter().copied().filter(|key| !is_idle(key.path)).collect();
    if kept.is_empty() { last } else { kept }
}

/// The arguments with their keys.
fn keys<'py>(contact: &Inner, arguments: &Bound<'py, PyDict>) -> PyResult<Vec<Given<'py>>> {
    let mut given: Vec<(String, Given)> = Vec::new();
    for (name, value) in arguments {
        let name: String = name.extract()?;
        let key = match meant(contact, &name)[..] {
            [key] => key,
            [] if ["law", "method", "material"].iter().any(|word| name.ends_with(word)) => {
                let message = format!(
                    "{name}: words are not broadcast; make a Contact for each, or plm_impact.run a scenario with a sweep of them"
                );
                return Err(PyTypeError::new_err(message));
            }
            [] => {
                let refusal =
                    with(&contact.scenario, [format!("sweep.{}=[1]", serde_json::Value::from(name.as_str()))]);
                return Err(refusal.err().map_or_else(|| PyValueError::new_err(name), exception));
            }
            ref keys => {
                let names: Vec<_> = keys.iter().map(|key| key.path.replace('.', "_")).collect();
                let message = format!("{name}: may be {}; write one of them", names.join(" or "));
                return Err(PyValueError::new_err(message));
            }
        };
        if let Some((other, _)) = given.iter().find(|(_, other)| other.key.path == key.path) {
            return Err(refused(key, "", &format!("is given twice, as {other} and as {name}; keep one of the two")));
        }
        given.push((name, Given::new(key, &value)?));
    }
    // the order of the registry, so that results do not depend on the order of the arguments
    given.sort_by_key(|(_, given)| KEYS.iter().position(|key| key.path == given.key.path));
    Ok(given.into_iter().map(|(_, given)| given).collect())
}

/// The common shape of these values, and the values of each key in that shape.
fn broadcast(py: Python<'_>, given: &[Given]) -> PyResult<(Vec<usize>, Vec<Vec<f64>>)> {
    let shape = given.first().map_or(&[][..], Given::shape);
    if given.iter().all(|given| given.shape() == shape) {
        let columns = given.iter().map(|given| Ok(given.values()?.to_vec()));
        return Ok((shape.to_vec(), columns.collect::<PyResult<_>>()?));
    }
    let arrays = given.iter().map(|given| match &given.numbers {
        Numbers::One(value) => Ok(value.into_pyobject(py)?.into_any()),
        Numbers::Array(array) => Ok((**array).clone().into_any()),
    });
    let numpy = py.import("numpy")?;
    let arrays = numpy.call_method1("broadcast_arrays", PyTuple::new(py, arrays.collect::<PyResult<Vec<_>>>()?)?)?;
    let (mut shape, mut columns) = (Vec::new(), Vec::new());
    for array in arrays.try_iter()? {
        let array = numpy.call_method1("asarray", (array?, "float64", "C"))?.cast_into::<PyArrayDyn<f64>>()?;
        shape = array.shape().to_vec();
        columns.push(array.readonly().as_slice()?.to_vec());
    }
    Ok((shape, columns))
}

/// The table of impacts with these keys, broadcast against each other.
pub fn impacts(contact: &Inner, arguments: &Bound<'_, PyDict>) -> PyResult<Table> {
    let py = arguments.py();
    let given = keys(contact, arguments)?;
    let plan = plan(contact, &given)?;
    let (shape, columns) = broadcast(py, &given)?;
    let count = shape.iter().product();
    if count > 0 {
        warn(py, &py.detach(|| warnings_of(&plan, &contact.contact)))?;
    }
    let listed: Vec<_> = given.iter().zip(&columns).map(|(given, values)| (given.key, values.as_slice())).collect();
    let results = plan.results();
    let made = rows::listed(py, &plan, &contact.contact, &listed, count, &results)?;
    say_failures(py, count, made.status.iter().copied())?;
    let table = made.table(&plan, &results, columns.into_iter().map(Column::numbers).collect());
    keep(contact, &given, plan);
    Ok(Table::of_shape(shape, table))
}

/// Restitution at these speeds, in an array of their shape, or as a number for one speed.
pub fn restitution<'py>(contact: &Inner, speed: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = speed.py();
    let given = [Given::new(Key::find(SPEED).ok_or_else(|| PyValueError::new_err(SPEED))?, speed)?];
    let plan = plan(contact, &given)?;
    let key = given[0].key;
    let speeds = given[0].values()?;
    if !speeds.is_empty() {
        warn(py, &py.detach(|| warnings_of(&plan, &contact.contact)))?;
    }
    let is_exact = plan.scene.forces.is_none() && matches!(plan.scene.solver.method, Method::Auto | Method::ClosedForm);
    let restitutions = if is_exact {
        let mut restitutions = vec![0.0; speeds.len()];
        let fill = |restitutions: &mut [f64], speeds: &[f64]| {
            for (restitution, speed) in restitutions.iter_mut().zip(speeds) {
                *restitution = contact.contact.restitution(contact.scene.approach_at(*speed)).unwrap_or(f64::NAN);
            }
        };
        if speeds.len() <= FEW {
            py.detach(|| fill(&mut restitutions, speeds));
        } else {
            interruptible(py, |is_cancelled| {
                let pieces = restitutions.par_chunks_mut(TOGETHER).zip(speeds.par_chunks(TOGETHER));
                let pieces = pieces.filter(|_| !is_cancelled.load(Ordering::Relaxed));
                pieces.for_each(|(restitutions, speeds)| fill(restitutions, speeds));
            })?;
        }
        let failed = restitutions.iter().zip(speeds).filter(|(restitution, _)| restitution.is_nan());
        let of = |speed: &f64| contact.contact.restitution(contact.scene.approach_at(*speed));
        let status = |speed: &f64| of(speed).err().map_or(0, |error| code(error.into()));
        say_failures(py, speeds.len(), failed.map(|(_, speed)| status(speed)))?;
        restitutions
    } else {
        let columns: Vec<_> = plan.results().into_iter().filter(|column| column.name == "restitution").collect();
        let mut made = rows::listed(py, &plan, &contact.contact, &[(key, speeds)], speeds.len(), &columns)?;
        say_failures(py, speeds.len(), made.status.into_iter())?;
        made.columns.pop().unwrap_or_default()
    };
    keep(contact, &given, plan);
    match restitutions[..] {
        [restitution] if given[0].shape().is_empty() => Ok(restitution.into_pyobject(py)?.into_any()),
        _ => shaped(py, restitutions, given[0].shape()),
    }
}
