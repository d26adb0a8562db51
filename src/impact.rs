//! The impact: which branch now, what can end it, what comes of it.
//!
//! A [`Contact`] is what stays the same along a speed axis (bodies, law, scales); [`Contact::impact`] runs one impact on
//! it, [`Contact::closed_form`] gives the exact outcome without stepping. SI units at this border, dimensionless inside.

pub mod closed_form;
pub mod course;
pub mod essentials;
pub mod outcome;
pub mod scales;
pub mod validity;

use std::sync::LazyLock;

use thiserror::Error;

use crate::integrate::ode_solvers::{self, OdeSolvers};
use crate::integrate::{IntegrationError, Work};
use crate::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::material::{HalfSpace, OutOfFloatRange, Pair, Sphere};
use course::Recorder;
pub use course::{Event, Point};
pub use essentials::Essentials;
pub use outcome::{Accuracy, Branch, Energy, Impact, Outcome, TraceRow};
pub use scales::Scales;
pub use validity::Warning;

/// How an impact is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// `ode_solvers` Dormand-Prince 5(4).
    Dopri5,
    /// `ode_solvers` Dormand-Prince 8(5,3).
    Dop853,
}

impl Method {
    /// Every method under the name it has in scenarios and reports.
    pub const ALL: &[(&str, Self)] = &[("dopri5", Self::Dopri5), ("dop853", Self::Dop853)];

    /// The method of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, method)| *method)
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, method)| *method == self).map_or("unnamed", |(name, _)| name)
    }
}

/// Method and tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver {
    /// Which integrator.
    pub method: Method,
    /// Relative, on the dimensionless state.
    pub tolerance: f64,
}

impl Default for Solver {
    fn default() -> Self {
        Self { method: Method::Dop853, tolerance: 1e-10 }
    }
}

/// Why an impact has no result.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ImpactError {
    /// A quantity outside double precision.
    #[error(transparent)]
    Range(#[from] OutOfFloatRange),
    /// The integrator gave up.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}

/// A sphere, a half-space and the law between them: all that does not depend on the impact speed.
#[derive(Debug, Clone)]
pub struct Contact {
    sphere: Sphere,
    half_space: HalfSpace,
    pair: Pair,
    /// Law and scales of the yielding contact.
    yielding: Option<(Scales, Law)>,
}

impl Contact {
    /// Pairs the bodies under the PLM law (or Hertz alone, for a half-space without a yield strength).
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where a constant of the pair over- or underflows.
    pub fn try_new(
        sphere: Sphere,
        half_space: HalfSpace,
        coefficients: &PlmCoefficients,
        exponent: UnloadingExponent,
    ) -> Result<Self, OutOfFloatRange> {
        let pair = Pair::try_new(&sphere, &half_space)?;
        let yielding = pair.yield_point.map(|point| {
            let law = coefficients.law(&pair, point.contact_radius / pair.radius, exponent);
            (Scales::of_yield(&point), law)
        });
        Ok(Self { sphere, half_space, pair, yielding })
    }

    /// The sphere.
    #[must_use]
    pub fn sphere(&self) -> &Sphere {
        &self.sphere
    }

    /// The half-space.
    #[must_use]
    pub fn half_space(&self) -> &HalfSpace {
        &self.half_space
    }

    /// Effective modulus, mass, yield point.
    #[must_use]
    pub fn pair(&self) -> &Pair {
        &self.pair
    }

    /// Units, law and dimensionless speed of an impact: an elastic one is the same for every scene.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where peak force, indentation or energy leave double precision.
    pub fn scaled(&self, speed: f64) -> Result<(Scales, &Law, f64), OutOfFloatRange> {
        static HERTZ: LazyLock<Law> = LazyLock::new(Law::hertz);
        match &self.yielding {
            Some((scales, law)) if speed > scales.speed => Ok((*scales, law, speed / scales.speed)),
            _ => Ok((Scales::of_hertz(&self.pair, speed)?, &HERTZ, 1.0)),
        }
    }

    /// The exact outcome of an impact, without stepping.
    ///
    /// # Errors
    /// [`OutOfFloatRange`], see [`Contact::scaled`].
    pub fn closed_form(&self, speed: f64) -> Result<Impact, ImpactError> {
        let (scales, law, q) = self.scaled(speed)?;
        let exact = closed_form::solve(law, q);
        Impact::new(self, speed, &scales, law, &exact, &exact, Work::default(), &[])
    }

    /// What a table holds of the closed form, without the rest of an [`Impact`].
    ///
    /// # Errors
    /// [`OutOfFloatRange`], see [`Contact::scaled`].
    pub fn essentials(&self, speed: f64) -> Result<Essentials, OutOfFloatRange> {
        let (scales, law, q) = self.scaled(speed)?;
        Essentials::new(&self.pair, speed, &scales, law, &closed_form::solve(law, q))
    }

    /// Integrates one impact at `speed` \[m/s\]; with `samples`, records a trace of that many evenly spaced rows (first
    /// touch and separation among them) and a row for every other event.
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision or the integrator gives up.
    pub fn impact(&self, speed: f64, solver: &Solver, samples: Option<usize>) -> Result<Impact, ImpactError> {
        let (scales, law, q) = self.scaled(speed)?;
        let exact = closed_form::solve(law, q);
        let mut recorder = samples.map(|samples| Recorder::new(samples, exact.contact_time));
        let method = match solver.method {
            Method::Dopri5 => ode_solvers::Method::Dopri5,
            Method::Dop853 => ode_solvers::Method::Dop853,
        };
        let mut integrator = OdeSolvers::new(method, solver.tolerance);
        let outcome = course::integrate(law, q, &mut integrator, recorder.as_mut())?;
        let work = crate::integrate::Integrator::work(&integrator);
        let points = recorder.map_or_else(Vec::new, |recorder| recorder.points);
        let mut impact = Impact::new(self, speed, &scales, law, &outcome, &exact, work, &points)?;
        validity::check_accuracy(&mut impact, solver.tolerance);
        Ok(impact)
    }
}
