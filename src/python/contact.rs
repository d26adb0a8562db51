//! A contact of two bodies, and one of its impacts.

use std::ops::Deref;
use std::sync::Arc;

use pyo3::exceptions::{PyAttributeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList, PyString};
use serde_json::Value;

use super::cases;
use super::convert::{exception, from_json, refuse_lost, scenario_text, warn, with};
use super::force::force;
use super::table::{Column, Table};
use crate::error::Error;
use crate::impact::{self, TraceRow};
use crate::plan::Source;
use crate::plot;
use crate::report::overview::overview;
use crate::report::table;
use crate::run::texts;
use crate::scenario::{Kind, Scenario};
use crate::scene::quantity::SAMPLES;
use crate::scene::results::impact::{Single, results, trace};
use crate::scene::results::{Reported, fields};
use crate::scene::{KEYS, Key, Scene};

/// The key of the argument `speed`.
const SPEED: &str = "impact.speed";
/// The name of the contact in messages.
const NAME: &str = "Contact";

/// The data of a contact.
#[derive(Debug)]
pub struct Inner {
    scenario: Scenario,
    scene: Scene,
    contact: impact::Contact,
}

/// A sphere, a half-space and their contact law. The arguments are the tables of a scenario, each as a dict:
/// `Contact(sphere=dict(radius="5 mm", ...), half_space=dict(...), law=dict(plm={}), damping=dict(viscous=0.05))`.
/// All tables and keys of a single impact are allowed; the speed may be left out.
#[pyclass(frozen, module = "plm_impact")]
#[derive(Debug, Clone)]
pub struct Contact(Arc<Inner>);

impl Deref for Contact {
    type Target = Inner;

    fn deref(&self) -> &Inner {
        &self.0
    }
}

impl Contact {
    fn of(py: Python<'_>, source: &Source) -> PyResult<Self> {
        let scenario = Scenario::from_source(NAME, source).map_err(exception)?;
        if scenario.kind().map_err(exception)? != Kind::Impact {
            let message = "a Contact has the tables of one impact; use plm_impact.impacts for tables, plm_impact.run for all else";
            return Err(PyValueError::new_err(message));
        }
        let scene = if scenario.document.has("impact") {
            scenario.resolve()
        } else {
            // the scenario needs a speed; any speed is right, because it is not used
            with(&scenario, [format!("{SPEED}=1")])
                .and_then(|any| any.resolve())
                .map(|scene| Scene { speed: f64::NAN, ..scene })
        };
        let scene = scene.map_err(exception)?;
        let contact = scene.contact().map_err(|reason| exception(no_result(&scenario, &reason)))?;
        warn(py, &texts(&scene.warnings))?;
        Ok(Self(Arc::new(Inner { scenario, scene, contact })))
    }

    /// The speed of an impact \[m/s\].
    fn speed(&self, speed: Option<&Bound<'_, PyAny>>) -> PyResult<f64> {
        let refused = |message: String| PyValueError::new_err(format!("{SPEED}: {message}"));
        match speed {
            // the error says what is missing
            None => Ok(self.scenario.resolve().map_err(exception)?.speed),
            Some(speed) => {
                let quantity = speed_key()?.quantity;
                if let Ok(text) = speed.cast::<PyString>() {
                    return quantity.parse(&text.to_cow()?).map_err(refused);
                }
                refuse_lost(speed, SPEED)?;
                quantity.check(speed.extract()?).map_err(|error| refused(error.to_string()))
            }
        }
    }

    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    pub fn computed(&self, speed: f64, samples: Option<usize>) -> Result<impact::Impact, Error> {
        let refuse = |reason| no_result(&self.scenario, &reason);
        self.contact.holds(speed).map_err(refuse)?;
        self.contact.impact(speed, &self.scene.solver, samples).map_err(refuse)
    }
}

fn speed_key() -> PyResult<&'static Key> {
    KEYS.iter().find(|key| key.path == SPEED).ok_or_else(|| PyValueError::new_err(SPEED))
}

/// A table of impacts of a contact. Every other argument is a numeric key with its values. The key is named by the last
/// part of its path (`speed`), by all parts (`half_space_yield_strength`), or by the path itself (`**{"impact.speed":
/// v}`). Values are numbers in SI units, arrays of numbers, or a text with a unit; arrays are broadcast against each
/// other.
#[pyfunction]
#[pyo3(signature = (contact, /, **keys))]
pub fn impacts(contact: &Contact, keys: Option<&Bound<'_, PyDict>>) -> PyResult<Table> {
    let none = || PyValueError::new_err("no key is given; write one such as speed=[1.0, 2.0]");
    cases::impacts(&contact.scenario, keys.ok_or_else(none)?)
}

#[pymethods]
impl Contact {
    #[new]
    #[pyo3(signature = (**tables))]
    fn new(py: Python<'_>, tables: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let text = tables.map_or_else(|| Ok(String::new()), scenario_text)?;
        Self::of(py, &Source { text, ..Source::default() })
    }

    /// The coefficient of restitution at these speeds (an array or a number), as in a table: by the closed form if
    /// there is one, and on all cores.
    fn restitution<'py>(&self, speed: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        cases::restitution(&self.scenario, speed_key()?, speed)
    }

    /// One impact at a speed, which is a number in m/s or a text with a unit. With `samples` it has a trace with
    /// this number of rows evenly spaced in time, and a row for every event.
    #[pyo3(signature = (speed=None, *, samples=None))]
    fn impact(&self, py: Python<'_>, speed: Option<&Bound<'_, PyAny>>, samples: Option<usize>) -> PyResult<Impact> {
        let speed = self.speed(speed)?;
        if let Some(samples) = samples {
            #[allow(clippy::cast_precision_loss)]
            SAMPLES.check(samples as f64).map_err(|error| PyValueError::new_err(format!("samples: {error}")))?;
        }
        let impact = py.detach(|| self.computed(speed, samples)).map_err(exception)?;
        warn(py, &texts(&impact.warnings))?;
        Ok(Impact { contact: self.clone(), impact })
    }

    /// The force of the law \[N\] on n contacts at their indentations \[m\], and their memory afterwards. The memory
    /// has a row for each contact: the largest indentation so far \[m\], the force there \[N\], and the part of this
    /// indentation that is recovered on unloading \[m\]. A row of zeros, or no memory, is a contact that was never
    /// loaded. Speed and damping are not included.
    #[pyo3(signature = (indentation, memory=None))]
    fn force<'py>(
        &self,
        indentation: &Bound<'py, PyAny>,
        memory: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        force(&self.contact, indentation, memory)
    }

    /// The bodies and the law, as `plm-impact check` shows them.
    fn __repr__(&self) -> String {
        let lines = overview(&self.scene, &self.contact);
        let lines = lines.lines().filter(|line| !line.starts_with(SPEED) || self.scene.speed.is_finite());
        lines.fold("<plm_impact.Contact>".to_owned(), |text, line| text + "\n" + line)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        let texts = serde_json::to_string(&slf.get().scenario.source().map_err(exception)?);
        Ok((slf.get_type().getattr("_of_texts")?, (texts.map_err(unexpected)?,)))
    }

    #[staticmethod]
    fn _of_texts(py: Python<'_>, texts: &str) -> PyResult<Self> {
        Self::of(py, &serde_json::from_str(texts).map_err(unexpected)?)
    }
}

#[allow(clippy::needless_pass_by_value)] // for map_err
fn unexpected(error: serde_json::Error) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// One impact. Its results are attributes with the names of `summary.json`: `impact.restitution`,
/// `impact.contact_time_s`, `impact.energy` (a dict). `dir(impact)` lists them. A result without a value is `None`.
#[pyclass(frozen, module = "plm_impact")]
#[derive(Debug)]
pub struct Impact {
    contact: Contact,
    impact: impact::Impact,
}

impl Impact {
    fn single(&self) -> Single<'_> {
        Single { contact: &self.contact.contact, impact: &self.impact }
    }

    /// The impact with a trace. If it has none, it is computed again with a trace.
    fn traced(&self) -> PyResult<std::borrow::Cow<'_, impact::Impact>> {
        if self.impact.trace.is_empty() {
            let samples = Some(self.contact.scene.samples);
            return Ok(std::borrow::Cow::Owned(self.contact.computed(self.impact.speed, samples).map_err(exception)?));
        }
        Ok(std::borrow::Cow::Borrowed(&self.impact))
    }
}

#[pymethods]
impl Impact {
    fn __getattr__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let of = self.single();
        if let Some(result) = results().iter().find(|result| result.name == name) {
            let missing = || PyAttributeError::new_err(format!("{name} is there only if {}", result.condition));
            return from_json(py, &(result.value)(&of).ok_or_else(missing)?);
        }
        let group = self.to_dict(py)?.get_item(name)?;
        group.ok_or_else(|| PyAttributeError::new_err(format!("an impact has no result \"{name}\"")))
    }

    fn __dir__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyList>> {
        let names = slf.py().import("builtins")?.getattr("object")?.call_method1("__dir__", (slf,))?;
        let names = names.cast_into::<PyList>()?;
        for name in slf.get().to_dict(slf.py())?.keys() {
            names.append(name)?;
        }
        Ok(names)
    }

    /// All results by name, as in `summary.json`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let value = serde_json::to_value(fields(&results(), &self.single()));
        let value = value.map_err(unexpected)?;
        Ok(from_json(py, &value)?.cast_into::<PyDict>()?)
    }

    /// The trace: a structured array with the columns of `trace.csv`.
    #[getter]
    fn trace<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let impact = py.detach(|| self.traced())?;
        of_rows(&trace(), &impact.trace).to_numpy(py)
    }

    fn __repr__(&self) -> String {
        format!("<plm_impact.Impact>\n{}", table(&self.contact.contact, &self.impact).trim_end())
    }

    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let picture = py.detach(|| {
            Ok::<_, PyErr>(
                plot::force_indentation(&*self.traced()?).and_then(|drawn| drawn.to_png()).map_err(exception),
            )
        });
        Ok(PyBytes::new(py, &picture??))
    }
}

/// The table of a trace, with the columns that have values.
fn of_rows(results: &[Reported<TraceRow>], rows: &[TraceRow]) -> Table {
    let there = results.iter().filter(|result| rows.first().is_some_and(|row| (result.value)(row).is_some()));
    let columns = there.map(|result| {
        let values: Vec<Value> = rows.iter().map(|row| (result.value)(row).unwrap_or_default()).collect();
        let column = if values.iter().any(Value::is_string) {
            Column::words(values.iter().map(|value| value.as_str().unwrap_or_default()))
        } else {
            Column::numbers(values.iter().map(|value| value.as_f64().unwrap_or(f64::NAN)).collect())
        };
        (result.name.to_owned(), column)
    });
    Table::new(columns.collect())
}
