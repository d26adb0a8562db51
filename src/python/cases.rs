//! Cases that are given as arrays of keys: finds the keys, checks the values, and makes the plan of their table.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyString, PyTuple};

use super::convert::{Numbers, exception, numbers, warn, with};
use super::rows::{listed, say_failures, without_axes};
use super::table::of_values;
use super::work;
use crate::impact::{self, Method};
use crate::plan::axis::{Axis, Values};
use crate::plan::{Cases, Plan};
use crate::run::table::warnings_of;
use crate::scenario::Scenario;
use crate::scene::{KEYS, Key, Scene};
use crate::sweep::arrow;
use crate::units::Dimension;

/// The key of the argument `speed`.
pub const SPEED: &str = "impact.speed";

/// A sphere, a half-space and their contact law. The arguments are the tables of a scenario, each as a dict:
///
///     steel = dict(youngs_modulus="210 GPa", poissons_ratio=0.3)
///     contact = Contact(sphere=dict(radius="5 mm", density="7850 kg/m^3", **steel),
///                       half_space=dict(yield_strength="345 MPa", **steel), law="thornton")
///
/// A value is a number in SI units or a text with a unit. All tables and keys of a single impact are allowed, such as
/// damping=dict(viscous=0.05); scenarios/README.md explains them. The speed may be left out, and the law may be a name
/// (see `laws()`) or a table such as dict(plm=dict(unloading_exponent="pressure-shape")).
///
/// A bad key or value raises ValueError, one of a wrong type TypeError; the message has the key, the value and what is
/// allowed. Warnings are UserWarning. A contact can be pickled, and threads may share it.
#[pyclass(frozen, module = "plm_impact")]
#[derive(Debug)]
pub struct Contact {
    pub scenario: Scenario,
    pub scene: Scene,
    /// Its bodies and their law.
    pub inner: impact::Contact,
    /// The plans of tables by the keys that vary in them, and whether the smallest value of a key is 0, which may switch
    /// gravity or damping off.
    pub plans: Mutex<HashMap<Vec<(&'static str, bool)>, Plan>>,
}

/// A key and its values in SI units, all of them in the allowed range.
pub struct Given {
    pub key: &'static Key,
    pub numbers: Numbers,
}

impl Given {
    /// A number, an array of numbers, or a text with a unit.
    pub fn new(key: &'static Key, value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let one = |value| Numbers { shape: Vec::new(), values: vec![value] };
        let numbers = if let Ok(text) = value.cast::<PyString>() {
            one(key.quantity.parse(&text.to_cow()?).map_err(|message| refused(key, "", &message))?)
        } else if value.cast_exact::<PyFloat>().is_ok() || value.cast_exact::<PyInt>().is_ok() {
            one(value.extract()?)
        } else {
            numbers(value, key.path)?
        };
        for (index, value) in numbers.values.iter().enumerate() {
            let place = || if numbers.values.len() == 1 { String::new() } else { format!(" at index {index}") };
            key.quantity.check(*value).map_err(|error| refused(key, &place(), &error))?;
        }
        Ok(Self { key, numbers })
    }

    /// The values of `speed`.
    pub fn speed(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::new(Key::find(SPEED).ok_or_else(|| PyValueError::new_err(SPEED))?, value)
    }

    /// The smallest and the largest value, or one where they are the same; none if there are no values.
    fn ends(&self) -> Vec<f64> {
        let values = || self.numbers.values.iter().copied();
        let mut ends: Vec<f64> =
            values().min_by(f64::total_cmp).into_iter().chain(values().max_by(f64::total_cmp)).collect();
        ends.dedup();
        ends
    }
}

fn refused(key: &Key, place: &str, message: &str) -> PyErr {
    PyValueError::new_err(format!("{}{place}: {message}", key.path))
}

/// The plan of a table in which these keys vary, each between its smallest and its largest value. It is refused for the
/// same reasons as a scenario with these axes. What does not depend on the values is found once for the same keys.
fn plan(contact: &Contact, given: &[Given]) -> PyResult<Plan> {
    let ends: Vec<Vec<f64>> = given.iter().map(Given::ends).collect();
    let keys: Vec<_> =
        given.iter().zip(&ends).map(|(given, ends)| (given.key.path, ends.first() == Some(&0.0))).collect();
    let mut plans = contact.plans.lock().unwrap_or_else(PoisonError::into_inner);
    let mut plan = if let Some(known) = plans.get(&keys) {
        known.clone()
    } else {
        let axes = given.iter().zip(&ends).map(|(Given { key, .. }, ends)| {
            // an array is in SI; in the text of a scenario an angle carries its unit
            let written = |low: &f64| match key.quantity.dimension {
                Dimension::Angle => format!("\"{low:?} rad\""),
                _ => format!("{low:?}"),
            };
            let value = ends.first().map_or_else(|| key.quantity.example.to_owned(), written);
            format!("sweep.\"{}\"=[{value}]", key.path)
        });
        let scenario = with(&contact.scenario, axes).map_err(exception)?;
        let plan = crate::run::table::plan(&scenario).map_err(exception)?;
        plans.insert(keys, plan.clone());
        plan
    };
    if ends.iter().all(|ends| !ends.is_empty()) {
        let axis = |(given, ends): (&Given, Vec<f64>)| Axis::of_number(given.key, Values::List(ends));
        plan.cases = Cases::Grid(given.iter().zip(ends).map(axis).collect());
    }
    Ok(plan)
}

/// The numeric keys that the name of an argument may mean. For `impact.speed` the names are `impact.speed`,
/// `impact_speed` and `speed`. The last part alone does not mean keys of other laws than that of the contact, nor the
/// strength of the sphere, which changes no table.
fn meant(contact: &Contact, name: &str) -> Vec<&'static Key> {
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
fn keys(contact: &Contact, arguments: &Bound<'_, PyDict>) -> PyResult<Vec<Given>> {
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

/// The same in one common shape.
fn broadcast(py: Python<'_>, given: Vec<Given>) -> PyResult<Vec<Given>> {
    if given.windows(2).all(|pair| pair[0].numbers.shape == pair[1].numbers.shape) {
        return Ok(given);
    }
    let (keys, arrays): (Vec<_>, Vec<_>) = given.into_iter().map(|given| (given.key, given.numbers.numpy(py))).unzip();
    let arrays = PyTuple::new(py, arrays.into_iter().collect::<PyResult<Vec<_>>>()?)?;
    let arrays = py.import("numpy")?.call_method1("broadcast_arrays", arrays)?;
    let given = |(key, array): (&'static Key, PyResult<Bound<'_, PyAny>>)| {
        Ok(Given { key, numbers: numbers(&array?, key.path)? })
    };
    keys.into_iter().zip(arrays.try_iter()?).map(given).collect()
}

/// The table of impacts with these keys, broadcast against each other.
pub fn impacts<'py>(contact: &Contact, arguments: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyAny>> {
    let py = arguments.py();
    let given = keys(contact, arguments)?;
    let plan = plan(contact, &given)?;
    let given = broadcast(py, given)?;
    let shape = given.first().map_or_else(Vec::new, |given| given.numbers.shape.clone());
    let count = shape.iter().product();
    if count > 0 {
        warn(py, &py.detach(|| warnings_of(&plan, &contact.inner)))?;
    }
    let keys: Vec<_> = given.iter().map(|given| (given.key, given.numbers.values.as_slice())).collect();
    let named = without_axes(&plan);
    let values = listed(py, &plan, &contact.inner, &keys, count, &named)?;
    say_failures(py, values.last().map_or(&[], Vec::as_slice))?;
    let columns = given.into_iter().map(|Given { key, numbers }| (key.column(), numbers.values));
    of_values(py, &shape, columns, named, values)
}

/// Restitution at these speeds, in an array of their shape, or as a number for one speed.
pub fn restitution<'py>(contact: &Contact, speed: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = speed.py();
    let given = [Given::speed(speed)?];
    let plan = plan(contact, &given)?;
    let [Given { key, numbers: Numbers { shape, values: speeds } }] = given;
    if !speeds.is_empty() {
        warn(py, &py.detach(|| warnings_of(&plan, &contact.inner)))?;
    }
    let Scene { forces, solver, .. } = &plan.scene;
    let is_exact = forces.is_none() && solver.method.chosen(forces, false) == Some(Method::ClosedForm);
    let computed = if is_exact {
        let of = |speed: &f64| match contact.inner.restitution(contact.scene.approach_at(*speed)) {
            Ok(restitution) => (restitution, 0.0),
            Err(error) => (f64::NAN, arrow::code(error.into())),
        };
        work::columns(py, speeds.len(), &[1, 1], false, |cases| {
            let (restitutions, status): (Vec<f64>, Vec<f64>) = speeds[cases].iter().map(of).unzip();
            Ok(vec![restitutions, status])
        })?
    } else {
        let mut named = without_axes(&plan);
        named.retain(|(name, _)| ["restitution", "status"].contains(&name.as_str()));
        listed(py, &plan, &contact.inner, &[(key, &speeds)], speeds.len(), &named)?
    };
    let [restitutions, status]: [Vec<f64>; 2] = computed.try_into().unwrap_or_default();
    say_failures(py, &status)?;
    Numbers { shape, values: restitutions }.numpy(py)
}
