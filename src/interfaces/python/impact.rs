//! One impact of a contact.

use std::sync::OnceLock;

use pyo3::exceptions::PyAttributeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};

use super::cases::PyContact;
use super::convert::{Reduced, exception, from_json, html, json_error};
use super::table::table_of_csv;
use crate::error::Error;
use crate::impact;
use crate::report::pictures;
use crate::report::text::{Detail, impact_blocks, to_text, trace_csv};
use crate::results::dent_interval::DentInterval;
use crate::results::impact::{SingleImpact, impact_results};
use crate::results::{TABLES, to_fields};
use crate::scenario::keys::{RestitutionInterval, dent_interval, restitution_interval, strength_notes};
use crate::strings::did_you_mean;

/// One impact. Its results are attributes with the names of `summary.json`: `impact.restitution`,
/// `impact.contact_time_s`, `impact.energy` (a dict). `dir(impact)` lists them. A result without a value is `None`; one that
/// this contact does not have raises AttributeError. `impact.trace` is the trace, computed when it is asked for. A pickled
/// impact is computed again when it is read.
#[pyclass(frozen, name = "Impact", module = "plm_impact")]
#[derive(Debug)]
pub struct PyImpact {
    contact: Py<PyContact>,
    /// The speed that it was asked for (m/s).
    speed: f64,
    pub(super) result: impact::Impact,
    /// The contact with the strength of this impact, where that depends on the speed.
    own: Option<impact::Contact>,
    samples: Option<usize>,
    /// The interval of e. It is computed when the first result is asked for, and then serves all results.
    interval: OnceLock<Option<RestitutionInterval>>,
    /// The interval of the dent, likewise.
    dent_interval: OnceLock<Option<DentInterval>>,
    /// The pulse, if the scenario asks for one.
    pulse: Option<impact::Pulse>,
    /// Notes for the user on the strength and on the exponent behind e.
    pub(super) notes: Vec<String>,
    /// The impact with a trace, if `result` has none; and the trace as an array. Each is computed when it is asked for first.
    traced: OnceLock<impact::Impact>,
    trace: OnceLock<Py<PyAny>>,
}

impl PyImpact {
    pub(super) fn compute(
        py: Python<'_>,
        contact: Py<PyContact>,
        speed: f64,
        samples: Option<usize>,
    ) -> PyResult<Self> {
        let holder = contact.get();
        let computed = || -> Result<_, Error> {
            let own = holder.at_rate_of(speed)?;
            let pulse = holder.compute_pulse(own.as_ref(), speed)?;
            Ok((holder.compute_impact(own.as_ref(), speed, samples)?, pulse, own))
        };
        let (result, pulse, own) = py.detach(computed).map_err(exception)?;
        let notes = strength_notes(&holder.input, own.as_ref().unwrap_or(&holder.inner), result.row.has_dent(), &[]);
        Ok(Self {
            contact,
            speed,
            result,
            own,
            samples,
            interval: OnceLock::new(),
            dent_interval: OnceLock::new(),
            pulse,
            notes,
            traced: OnceLock::new(),
            trace: OnceLock::new(),
        })
    }

    fn single_impact(&self) -> SingleImpact<'_> {
        let contact = self.contact.get();
        let own = self.own.as_ref().unwrap_or(&contact.inner);
        let interval = || restitution_interval(&contact.input, own, self.speed, &self.result.row);
        let interval = self.interval.get_or_init(interval).as_ref();
        let drop_height = contact.input.drop_height();
        let row = &self.result.row;
        let has_dent_interval = row.peened.is_some() && interval.is_some();
        let of_dent = || dent_interval(&contact.input, own, self.speed, row).filter(|_| has_dent_interval);
        let dent_interval = self.dent_interval.get_or_init(of_dent).as_ref();
        SingleImpact {
            contact: own,
            impact: &self.result,
            interval,
            dent_interval,
            notes: &self.notes,
            drop_height,
            pulse: self.pulse.as_ref(),
        }
    }

    /// The impact with a trace. If it has none, it is computed again with a trace.
    fn impact_with_trace(&self) -> PyResult<&impact::Impact> {
        if self.result.trace.is_empty() {
            if let Some(traced) = self.traced.get() {
                return Ok(traced);
            }
            let contact = self.contact.get();
            let impact = contact.compute_impact(self.own.as_ref(), self.speed, Some(contact.input.samples()));
            let impact = impact.map_err(exception)?;
            return Ok(self.traced.get_or_init(|| impact));
        }
        Ok(&self.result)
    }
}

#[pymethods]
impl PyImpact {
    fn __getattr__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let single = self.single_impact();
        if let Some(result) = impact_results().iter().find(|result| result.name == name) {
            let missing = || {
                PyAttributeError::new_err(match result.condition {
                    TABLES => format!("{name} is {TABLES}. Use plm_impact.impacts."),
                    condition => format!("{name} is available only if {condition}"),
                })
            };
            return from_json(py, &(result.value)(&single).ok_or_else(missing)?);
        }
        let there = self.to_dict(py)?;
        if let Some(group) = there.get_item(name)? {
            return Ok(group);
        }
        let names: Vec<String> = there.keys().extract()?;
        let hint = did_you_mean(name, names.iter().map(String::as_str), '"', "dir(impact) lists all");
        Err(PyAttributeError::new_err(format!("an impact has no result \"{name}\"{hint}")))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> Reduced<'py, (Py<PyContact>, f64, Option<usize>)> {
        let Self { contact, speed, samples, .. } = slf.get();
        Ok((slf.get_type().getattr("_from_speed")?, (contact.clone_ref(slf.py()), *speed, *samples)))
    }

    #[staticmethod]
    fn _from_speed(py: Python<'_>, contact: Py<PyContact>, speed: f64, samples: Option<usize>) -> PyResult<Self> {
        Self::compute(py, contact, speed, samples)
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
        let value = serde_json::to_value(to_fields(&impact_results(), &self.single_impact()));
        let value = value.map_err(json_error)?;
        Ok(from_json(py, &value)?.cast_into::<PyDict>()?)
    }

    /// The trace: a read-only structured array with the columns of `trace.csv`.
    #[getter]
    fn trace<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        if let Some(array) = self.trace.get() {
            return Ok(array.bind(py).clone());
        }
        let csv = py.detach(|| trace_csv(self.impact_with_trace()?).map_err(exception))?;
        let array = table_of_csv(py, &csv)?.call_method0("to_numpy")?;
        // every access gives the same array
        array.call_method1("setflags", (false,))?;
        let array = array.unbind();
        Ok(self.trace.get_or_init(|| array).bind(py).clone())
    }

    fn __repr__(&self) -> String {
        format!("<plm_impact.Impact>\n{}", to_text(&impact_blocks(&self.single_impact(), Detail::Normal)).trim_end())
    }

    /// The picture of the force against the indentation, as PNG.
    #[getter]
    fn picture<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let picture = py.detach(|| {
            let caption = pictures::caption::caption(&self.contact.get().input, &[]);
            let drawn = pictures::force_indentation(self.impact_with_trace()?).map_err(exception)?;
            Ok::<_, PyErr>(drawn.with_caption(caption).to_png().map_err(exception))
        });
        Ok(PyBytes::new(py, &picture??))
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        html(slf.as_any(), Some(slf.get().picture(slf.py())?))
    }
}
