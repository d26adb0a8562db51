//! The values of a key that give a wanted result, as `plm-impact find` prints them.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

use super::convert::{exception, from_json, overrides, warn};
use super::outcome::scenario_of;
use super::workers::interruptible;
use crate::error::Error;
use crate::report::run::find::{Question, find as find_values};
use crate::scenario::kinds::inverse::{find_result, read_result};

/// Finds all values of a key for which an impact has a wanted result:
///
///     [found] = find("impact.drop_height", "drop.toml", dent_diameter="1 mm")
///     found["impact_drop_height_m"], found["results"]["restitution"]
///
/// The wanted result is one named argument: the name of a result of an impact, with or without its unit, and its value, a number in
/// SI units or a text with a unit. `restitution` is the measured one: with elastic waves if the half-space has a density.
/// `between=("1 mm", "2 m")` is the range of the key; without it the range follows from the scenario. `set` changes keys of the
/// scenario as in `run`.
///
/// Returns a list of dicts with the key, the wanted result, and all results of the impact, in the order of rising values. If every value
/// in a part of the range is a solution, the dict has the ends of this part too, such as `impact_speed_m_per_s_interval`.
///
/// Raises ValueError if there is no solution; the message has the range of the result. Other errors are those of `run`.
#[pyfunction]
#[pyo3(signature = (key, scenario, /, *, between=None, set=None, **result))]
pub fn find<'py>(
    py: Python<'py>,
    key: &str,
    scenario: &Bound<'py, PyAny>,
    between: Option<(Bound<'py, PyAny>, Bound<'py, PyAny>)>,
    set: Option<&Bound<'py, PyMapping>>,
    result: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let scenario = scenario_of(scenario, overrides(set)?)?;
    let given: Vec<(String, Bound<'_, PyAny>)> = match result {
        Some(result) => result.items().extract()?,
        None => Vec::new(),
    };
    let [(name, value)] = &given[..] else {
        let count = given.len();
        let message = format!("find needs one result, such as dent_diameter=\"1 mm\", and {count} are given");
        return Err(PyTypeError::new_err(message));
    };
    let result = find_result(name).map_err(|message| exception(Error::input(message)))?;
    let wanted = read_result(result, &value_text(value)?)
        .map_err(|message| exception(Error::input(format!("{name}: {message}"))))?;
    let ends = match between {
        Some((from, to)) => [end_text(&from)?, end_text(&to)?],
        None => [None, None],
    };
    let range = ends.each_ref().map(Option::as_deref);
    let question = Question { key, range, result, wanted };
    let answer = interruptible(py, |progress| find_values(&scenario, &question, progress))?.map_err(exception)?;
    warn(py, 1, &answer.warnings)?;
    from_json(py, &answer.json["solutions"])
}

/// A number in SI units, or a text with a unit, as text.
fn value_text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    value.extract::<String>().or_else(|_| Ok(format!("{:?}", value.extract::<f64>()?)))
}

/// An end of a range; `None` for the default.
fn end_text(end: &Bound<'_, PyAny>) -> PyResult<Option<String>> {
    if end.is_none() { Ok(None) } else { value_text(end).map(Some) }
}
