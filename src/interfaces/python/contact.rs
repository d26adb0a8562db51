//! A contact of two bodies.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::sync::Mutex;

use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::cases::{self, KeyValues, PyContact, SPEED};
use super::convert::{Numbers, Reduced, exception, html, json_error, source_of, warn, with_overrides};
use super::force::{Rubbing, energy, force, friction, stiffness};
use super::impact::PyImpact;
use crate::error::Error;
use crate::impact;
use crate::interfaces::export::header::header_files;
use crate::report::run::impact::compute_pulse;
use crate::report::run::{no_result_error, rate_dependent_contact, warning_texts};
use crate::report::text::overview::overview;
use crate::report::text::to_text;
use crate::scenario::keys::interval::expected_notes;
use crate::scenario::keys::key;
use crate::scenario::keys::quantity::SAMPLES;
use crate::scenario::{Kind, Scenario, ScenarioSource};

/// The name of the contact in messages.
const NAME: &str = "Contact";

impl PyContact {
    /// The contact, and the warnings about its keys.
    fn from_source(source: &ScenarioSource) -> PyResult<(Self, Vec<String>)> {
        let scenario = Scenario::from_source(NAME, source).map_err(exception)?;
        if scenario.kind().map_err(exception)? != Kind::Impact {
            let message = "a Contact has the tables of one impact; use plm_impact.impacts for tables, plm_impact.run for all else";
            return Err(PyValueError::new_err(message));
        }
        let input = if scenario.document.contains("impact") {
            scenario.resolve()
        } else {
            // the scenario needs a speed; any speed is right, because it is not used
            with_overrides(&scenario, [format!("{SPEED}=1")]).and_then(|any| any.resolve()).map(|mut input| {
                input.set(key!("impact.speed"), None);
                input
            })
        };
        let input = input.map_err(exception)?;
        let contact = input.contact().map_err(|reason| exception(no_result_error(&scenario, &reason)))?;
        let warnings = warning_texts(&scenario.unused_key_warnings(std::slice::from_ref(&input), Kind::Impact));
        Ok((Self { scenario, input, inner: contact, plans: Mutex::default() }, warnings))
    }

    /// The speed of an impact (m/s).
    fn speed(&self, speed: Option<&Bound<'_, PyAny>>) -> PyResult<f64> {
        // without a speed the error says what is missing
        let Some(speed) = speed else { return Ok(self.scenario.resolve().map_err(exception)?.speed()) };
        match KeyValues::speed(speed)?.check()?.numbers {
            Numbers { shape, values } if shape.is_empty() && values.len() == 1 => Ok(values[0]),
            _ => Err(PyTypeError::new_err(format!(
                "{SPEED}: found {}, expected one number or text; restitution and plm_impact.impacts take arrays",
                speed.get_type()
            ))),
        }
    }

    /// The contact, with the strength of its own speed if it depends on one.
    fn at_own_rate(&self) -> PyResult<Cow<'_, impact::Contact>> {
        let own = rate_dependent_contact(&self.scenario, &self.input, &self.inner).map_err(exception)?;
        Ok(own.map_or(Cow::Borrowed(&self.inner), Cow::Owned))
    }

    /// The contact with the strength of an impact at this speed; `None` where it does not depend on the speed.
    pub(super) fn at_rate_of(&self, speed: f64) -> Result<Option<impact::Contact>, Error> {
        let normal = self.input.approach_at(speed).normal;
        let own = self.inner.has_rate().then(|| self.inner.at_speed(normal)).transpose();
        own.map(|own| own.map(Cow::into_owned)).map_err(|reason| no_result_error(&self.scenario, &reason))
    }

    pub(super) fn compute_pulse(
        &self,
        own: Option<&impact::Contact>,
        speed: f64,
    ) -> Result<Option<impact::Pulse>, Error> {
        let normal = self.input.approach_at(speed).normal;
        compute_pulse(&self.scenario, &self.input, own.unwrap_or(&self.inner), normal)
    }

    pub(super) fn compute_impact(
        &self,
        own: Option<&impact::Contact>,
        speed: f64,
        samples: Option<usize>,
    ) -> Result<impact::Impact, Error> {
        let refuse = |reason| no_result_error(&self.scenario, &reason);
        let approach = self.input.approach_at(speed);
        own.unwrap_or(&self.inner).impact(approach, &self.input.solver(), samples).map_err(refuse)
    }
}

#[pymethods]
impl PyContact {
    #[new]
    #[pyo3(signature = (**tables), text_signature = "(*, sphere, half_space, **tables)")]
    fn new(py: Python<'_>, tables: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let source = tables.map_or_else(|| Ok(ScenarioSource::default()), |tables| source_of(tables.as_mapping()))?;
        let (contact, warnings) = Self::from_source(&source)?;
        warn(py, 1, &warnings)?;
        Ok(contact)
    }

    /// The coefficient of restitution at these speeds (an array of any shape, a number, or a text with a unit), as in a
    /// table: by the closed form if there is one, and for many speeds on all cores. A speed that is NaN or not allowed, such as
    /// one of 0, gives NaN, and a ModelWarning names its index. Elastic waves are not in it; see `restitution_with_waves` of
    /// `impact` and `impacts`.
    fn restitution<'py>(&self, speed: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        cases::restitution(self, speed)
    }

    /// One impact at a speed, which is a number in m/s or a text with a unit. With `samples` it has a trace with
    /// this number of rows evenly spaced in time, and a row for every event.
    #[pyo3(signature = (speed=None, *, samples=None))]
    fn impact(
        slf: &Bound<'_, Self>,
        speed: Option<&Bound<'_, PyAny>>,
        samples: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<PyImpact> {
        // without a speed it is that of the scenario, which may be that of a fall
        let falls = speed.is_none();
        let speed = slf.get().speed(speed)?;
        let samples = samples.map(whole_number).transpose()?;
        if let Some(samples) = samples {
            SAMPLES.check(samples as f64).map_err(|error| PyValueError::new_err(format!("samples: {error}")))?;
        }
        let samples = samples.and_then(|samples| samples.try_into().ok());
        let mut impact = PyImpact::compute(slf.py(), slf.clone().unbind(), speed, samples)?;
        if falls {
            impact.result.warnings.extend(slf.get().input.flight_warnings());
        }
        let warnings = [warning_texts(&impact.result.warnings), impact.notes.clone()].concat();
        warn(slf.py(), 1, &warnings)?;
        Ok(impact)
    }

    /// The force of the law (N) at the indentations (m) of any number of contacts, and their memory afterwards. A memory
    /// has three numbers for each contact: the largest indentation so far (m), the force there (N), and the part of this
    /// indentation that is recovered on unloading (m). So its shape is that of the indentations and a last axis of 3.
    /// Zeros, or no memory, are a contact that was never loaded.
    ///
    /// The memory belongs to one spot of the surface. Set it to zero when the sphere has left (indentation <= 0), unless
    /// the sphere comes back to the same spot. Do not do so earlier, where the force ends at the depth of the dent.
    ///
    /// The force has no gravity, damping or elastic waves: they are those of the program that moves the spheres. A whole
    /// loop, in which spheres fall on fresh surface again and again:
    ///
    ///     mass, dt = 7850 * 4 / 3 * np.pi * 5e-3**3, 5e-7     # dt: a hundredth of a contact, which takes 60 us here
    ///     height, speed = np.full(2, 1e-6), np.array([-0.05, -0.02])  # of the lowest point of each sphere (m, m/s)
    ///     force, memory = contact.force(-height)
    ///     for step in range(100_000):                         # velocity Verlet
    ///         speed += 0.5 * dt * (force / mass - 9.81)
    ///         height += dt * speed
    ///         force, memory = contact.force(-height, memory)
    ///         memory[height >= 0] = 0                         # has left: the next contact is a fresh one
    ///         speed += 0.5 * dt * (force / mass - 9.81)
    ///
    /// Two balls are a scenario with half_space = dict(radius=..., mass="ball", density=..., ...). Their overlap is the
    /// indentation, and their relative motion has the reduced mass. From the first touch to the last:
    ///
    ///     overlap, speed, dt = 0.0, 3.0, 1e-7                 # of the two balls: m, m/s of the approach, s
    ///     force, memory = balls.force(overlap)
    ///     while overlap >= 0:
    ///         speed -= 0.5 * dt * force / balls.reduced_mass_kg
    ///         overlap += dt * speed
    ///         force, memory = balls.force(overlap, memory)
    ///         speed -= 0.5 * dt * force / balls.reduced_mass_kg
    ///
    /// An indentation or a memory that is not finite, and a memory that no path of this contact leads to, raise ValueError.
    #[pyo3(signature = (indentation, memory=None))]
    fn force<'py>(
        &self,
        indentation: &Bound<'py, PyAny>,
        memory: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        Ok(force(self.at_own_rate()?.as_ref(), indentation, memory)?.into())
    }

    /// The energy that is stored in the contacts, which unloading gives back, and the plastic work of their dents (J). The
    /// memories are those that `force` returned at these indentations.
    fn energy<'py>(
        &self,
        indentation: &Bound<'py, PyAny>,
        memory: &Bound<'py, PyAny>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        Ok(energy(self.at_own_rate()?.as_ref(), indentation, memory)?.into())
    }

    /// The tangent stiffness dF/d(indentation) (N/m): of the unloading branch up to the largest indentation so far, and of
    /// the loading curve beyond it.
    #[pyo3(signature = (indentation, memory=None))]
    fn stiffness<'py>(
        &self,
        indentation: &Bound<'py, PyAny>,
        memory: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        stiffness(self.at_own_rate()?.as_ref(), indentation, memory)
    }

    /// The law as a C header without dependencies: a dict of three files, by name. `plm_NAME.h` is the header (C99, C++, CUDA),
    /// `plm_NAME_vectors.csv` has 1000 states with their forces, and `plm_NAME_test.c` tests a build of the header with them. Write
    /// them with
    ///
    ///     for file, text in contact.header("steel").items():
    ///         pathlib.Path(file).write_text(text)
    #[pyo3(signature = (name="pair"))]
    fn header(&self, name: &str) -> PyResult<BTreeMap<String, String>> {
        let files = header_files(&self.scenario, name, "Python: Contact.header").map_err(exception)?;
        Ok(files.into_iter().map(|file| (file.name, String::from_utf8_lossy(&file.bytes).into_owned())).collect())
    }

    /// The friction on the sphere (N) after a time step, by one tangential spring and Coulomb's limit, as
    /// mindlin_rescale/force of LAMMPS. It is the `history` of the next step, and has three numbers for each contact. Call it
    /// after `force` returned `memory` at `indentation`. `previous_indentation` is that of the last step, 0 in the first;
    /// `slip` is the way of the contact point along the surface in this step (m), three numbers too. The torque about the centre
    /// is that of this force at the contact point.
    #[pyo3(signature = (coefficient, previous_indentation, indentation, memory, slip, history=None))]
    fn friction<'py>(
        &self,
        coefficient: f64,
        previous_indentation: &Bound<'py, PyAny>,
        indentation: &Bound<'py, PyAny>,
        memory: &Bound<'py, PyAny>,
        slip: &Bound<'py, PyAny>,
        history: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rubbing = Rubbing { previous_indentation, indentation, slip };
        friction(self.at_own_rate()?.as_ref(), coefficient, &rubbing, memory, history)
    }

    /// Mass of the sphere (kg).
    #[getter]
    fn mass_kg(&self) -> f64 {
        self.inner.mass()
    }

    /// Mass of the relative motion (kg): m1 m2/(m1 + m2) if the half-space is free to move, and else the mass of the sphere.
    #[getter]
    fn reduced_mass_kg(&self) -> f64 {
        self.inner.reduced_mass()
    }

    /// Impact speed above which the half-space yields (m/s); `None` if it cannot yield.
    #[getter]
    fn yield_speed_m_per_s(&self) -> PyResult<Option<f64>> {
        Ok(self.at_own_rate()?.yield_speed())
    }

    /// Indentation at first yield (m); `None` if it cannot yield.
    #[getter]
    fn yield_indentation_m(&self) -> PyResult<Option<f64>> {
        Ok(self.at_own_rate()?.yield_indentation_and_force().map(|(indentation, _)| indentation))
    }

    /// Force at first yield (N); `None` if it cannot yield.
    #[getter]
    #[pyo3(name = "yield_force_N")]
    fn yield_force(&self) -> PyResult<Option<f64>> {
        Ok(self.at_own_rate()?.yield_indentation_and_force().map(|(_, force)| force))
    }

    /// The name of the law.
    #[getter]
    fn _law(&self) -> &'static str {
        self.input.named_law.info().name
    }

    fn __eq__(&self, other: &Self) -> bool {
        let has_speed = |contact: &Self| contact.scenario.document.contains("impact");
        self.input == other.input && has_speed(self) == has_speed(other)
    }

    fn __hash__(&self) -> u64 {
        // equal inputs are written alike
        let mut hasher = DefaultHasher::new();
        format!("{:?}", self.input).hash(&mut hasher);
        hasher.finish()
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        html(slf.as_any(), None)
    }

    /// The bodies and the law, as `plm-impact check` shows them.
    fn __repr__(&self) -> String {
        let lines = to_text(&overview(&self.input, &self.inner, &expected_notes(&self.input, &self.inner)));
        let lines = lines.lines().filter(|line| !line.starts_with(SPEED) || self.input.speed().is_finite());
        lines.fold("<plm_impact.Contact>".to_owned(), |text, line| text + "\n" + line)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> Reduced<'py, (String,)> {
        let texts = serde_json::to_string(&slf.get().scenario.source());
        Ok((slf.get_type().getattr("_from_texts")?, (texts.map_err(json_error)?,)))
    }

    #[staticmethod]
    fn _from_texts(texts: &str) -> PyResult<Self> {
        // whoever made the contact had its warnings
        Ok(Self::from_source(&serde_json::from_str(texts).map_err(json_error)?)?.0)
    }
}

/// A whole number; one that is too large for 64 bits becomes the largest of them, which is then refused by its range.
fn whole_number(value: &Bound<'_, PyAny>) -> PyResult<i64> {
    let number = value.extract::<i64>();
    let is_too_large = |error: &PyErr| error.is_instance_of::<PyOverflowError>(value.py());
    if number.as_ref().is_err_and(is_too_large) { Ok(i64::MAX) } else { number }
}
