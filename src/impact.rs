//! The impact: which branch now, what can end it, what comes of it.
//!
//! A [`Contact`] is what stays the same along a speed axis (bodies, law, scales); [`Contact::impact`] runs one impact on
//! it, [`Contact::closed_form`] gives the exact outcome without stepping. SI units at this border, dimensionless inside.

pub mod balance;
pub mod batch;
pub mod closed_form;
pub mod course;
pub mod essentials;
pub mod forced;
pub mod forced_batch;
pub mod forced_trace;
pub mod forced_verlet;
pub mod forces;
pub mod method;
pub mod outcome;
pub mod scales;
pub mod spot;
pub mod validity;
pub mod waves;
pub mod with_forces;

use std::sync::LazyLock;

use thiserror::Error;

use crate::functions::pow;
use crate::integrate::{IntegrationError, Work};
use crate::law::{Bodies, ContactLaw, ElasticApproach, Law, OutsideLaw, PlmCoefficients, UnloadingExponent};
use crate::material::{HalfSpace, OutOfFloatRange, Pair, Sphere, normal};
use course::Recorder;
pub use course::{Event, Point};
pub use essentials::Essentials;
pub use forced::Fate;
pub use forces::{Damping, Forces, drop_speed};
pub use method::{Method, Solver, run};
pub use outcome::{Accuracy, Branch, Energy, Impact, Outcome, TraceRow};
pub use scales::Scales;
pub use spot::Spot;
pub use validity::Warning;
use waves::Waves;
pub use with_forces::UnderForces;

/// Why an impact has no result.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ImpactError {
    /// A quantity outside double precision.
    #[error(transparent)]
    Range(#[from] OutOfFloatRange),
    /// The integrator gave up.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The law has no answer for this impact.
    #[error(transparent)]
    Law(#[from] OutsideLaw),
    /// No closed form for this scene.
    #[error(
        "method \"closed_form\" gives no trace under gravity or damping; without a trace it gives gravity alone or Hunt-Crossley damping alone, on laws whose force is made of power laws and straight lines: use \"auto\" or \"rk8\""
    )]
    NoClosedForm,
}

/// A sphere, a half-space and the law between them: all that does not depend on the impact speed.
#[derive(Debug, Clone)]
pub struct Contact {
    sphere: Sphere,
    half_space: HalfSpace,
    pair: Pair,
    /// Of the sphere \[kg\].
    mass: f64,
    /// Law and scales of the yielding contact.
    yielding: Option<(Scales, Law)>,
    /// The slowest impact that yields \[m/s\]; infinite without one.
    yield_speed: f64,
    /// What acts beside the law.
    forces: Forces,
    /// How the half-space radiates, if its density is known.
    waves: Option<Waves>,
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
        let mass = normal("sphere mass (kg)", sphere.mass())?;
        let pair = Pair::try_new(sphere.radius, &sphere.material, &half_space)?;
        let yielding = pair.yield_point.map(|point| {
            let law = coefficients.law(&pair, point.contact_radius / pair.radius, exponent);
            Ok((Scales::of_yield(&point, point.speed(mass)?), law))
        });
        Self::new(sphere, half_space, pair, mass, yielding.transpose()?)
    }

    /// Pairs the bodies under any law (or Hertz alone, for a half-space without a yield strength).
    ///
    /// # Errors
    /// [`ImpactError::Range`] where a constant of the pair over- or underflows, [`ImpactError::Law`] for a law that has no
    /// loading or no unloading (see [`Combined`](crate::law::combined::Combined)).
    pub fn with_law(sphere: Sphere, half_space: HalfSpace, law: &dyn ContactLaw) -> Result<Self, ImpactError> {
        let mass = normal("sphere mass (kg)", sphere.mass())?;
        let pair = Pair::try_new(sphere.radius, &sphere.material, &half_space)?;
        let yielding = Bodies::new(&pair, &half_space).map(|bodies| {
            let point = bodies.yield_point;
            let name = law.about().name;
            let law = law.law(&bodies).ok_or(OutsideLaw::Incomplete { name })?;
            Ok::<_, ImpactError>((Scales::of_yield(&point, point.speed(mass)?), law))
        });
        Ok(Self::new(sphere, half_space, pair, mass, yielding.transpose()?)?)
    }

    fn new(
        sphere: Sphere,
        half_space: HalfSpace,
        pair: Pair,
        mass: f64,
        yielding: Option<(Scales, Law)>,
    ) -> Result<Self, OutOfFloatRange> {
        // ½ m v² = W = (2/5) x^2.5 in units of F_Y δ_Y, as Hertz up to there
        let yield_speed = yielding.as_ref().map_or(f64::INFINITY, |(scales, law)| {
            let until = law.elastic_until();
            if until == 1.0 { scales.speed } else { scales.speed * pow(until, 1.25) }
        });
        let waves = Waves::of(&half_space)?;
        Ok(Self { sphere, half_space, pair, mass, yielding, yield_speed, forces: Forces::default(), waves })
    }

    /// The same contact with gravity and damping.
    #[must_use]
    pub fn with_forces(self, forces: Forces) -> Self {
        Self { forces, ..self }
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

    /// Effective modulus, shares of compliance, yield point.
    #[must_use]
    pub fn pair(&self) -> &Pair {
        &self.pair
    }

    /// Gravity and damping.
    #[must_use]
    pub fn forces(&self) -> &Forces {
        &self.forces
    }

    /// How the half-space radiates elastic waves; `None` for one of unknown density.
    #[must_use]
    pub fn waves(&self) -> Option<&Waves> {
        self.waves.as_ref()
    }

    /// Mass of the sphere \[kg\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// The slowest impact that yields by the law \[m/s\], v_Y for the PLM; `None` for a contact that stays elastic, and for
    /// a law without an elastic regime.
    #[must_use]
    pub fn yield_speed(&self) -> Option<f64> {
        (self.yield_speed > 0.0 && self.yield_speed.is_finite()).then_some(self.yield_speed)
    }

    /// Indentation \[m\] and force \[N\] at which the contact yields by the law; `None` as for [`Contact::yield_speed`].
    #[must_use]
    pub fn yields_at(&self) -> Option<(f64, f64)> {
        let (scales, law) = self.yielding.as_ref()?;
        self.yield_speed()?;
        let until = law.elastic_until();
        Some((scales.length * until, scales.force * crate::power::power(until, 1.5)))
    }

    /// Units, law and dimensionless speed of an impact without gravity and damping: an elastic one is the same for every
    /// scene.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where peak force, indentation or energy leave double precision.
    pub fn scaled(&self, speed: f64) -> Result<(Scales, &Law, f64), OutOfFloatRange> {
        match &self.yielding {
            Some((scales, law)) if speed > self.yield_speed => {
                let ratio = speed / scales.speed;
                normal("kinetic energy in units of that at first yield", ratio * ratio)?;
                Ok((*scales, law, ratio))
            }
            _ => Ok((Scales::of_hertz(&self.pair, self.mass, speed)?, hertz(), 1.0)),
        }
    }

    /// The exact outcome of an impact, without stepping.
    ///
    /// # Errors
    /// [`OutOfFloatRange`], see [`Contact::scaled`].
    pub fn closed_form(&self, speed: f64) -> Result<Impact, ImpactError> {
        if !self.forces.is_none() {
            return self.closed_form_with_forces(speed);
        }
        let (scales, law, q) = self.scaled(speed)?;
        let exact = closed_form::solve(law, q);
        law.accept(&exact.unloading.peak)?;
        Impact::new(self, speed, Method::ClosedForm, &scales, law, &exact, &exact, Work::default(), &[])
    }

    /// What a table holds of an impact by [`Method::Auto`], without the rest of an [`Impact`]: of the closed form, or by
    /// rk8 at the default tolerance where [`Contact::auto_integrates`].
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision, the law has no answer, or the integrator gives up.
    #[inline]
    pub fn essentials(&self, speed: f64) -> Result<Essentials, ImpactError> {
        if self.forces.is_none() {
            return self.essentials_of_law(speed);
        }
        self.essentials_with_forces(speed, &Solver { method: Method::Auto, ..Solver::default() })
    }

    /// What a table holds of an impact by this solver.
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision, the law has no answer, the integrator gives up, or the
    /// method does not fit.
    pub fn essentials_by(&self, speed: f64, solver: &Solver) -> Result<Essentials, ImpactError> {
        match solver.method {
            _ if !self.forces.is_none() => self.essentials_with_forces(speed, solver),
            Method::Auto | Method::ClosedForm => self.essentials_of_law(speed),
            _ => Ok(Essentials::from(&self.impact(speed, solver, None)?)),
        }
    }

    /// Whether [`Method::Auto`] integrates rows of tables: with damping, and under gravity where the law is neither powers
    /// nor straight lines. Elsewhere it takes the closed form.
    #[must_use]
    pub fn auto_integrates(&self) -> bool {
        let is_open = || self.yielding.as_ref().is_some_and(|(_, law)| !balance::closes(law));
        self.forces.damping.is_some() || self.forces.gravity.is_some() && is_open()
    }

    /// Whether double precision holds an impact at `speed` \[m/s\]: what it does not hold no integration can.
    ///
    /// # Errors
    /// [`ImpactError`], see [`Contact::scaled`].
    pub fn holds(&self, speed: f64) -> Result<(), ImpactError> {
        if self.forces.is_none() {
            return self.closed_form(speed).map(|_| ());
        }
        self.holds_with_forces(speed)
    }

    fn essentials_of_law(&self, speed: f64) -> Result<Essentials, ImpactError> {
        // in its own scales every elastic impact is the same
        static ELASTIC: LazyLock<Outcome> = LazyLock::new(|| closed_form::solve(&Law::hertz(), 1.0));
        let (scales, law, q) = self.scaled(speed)?;
        let outcome = match law.elastic {
            ElasticApproach::All if q == 1.0 => *ELASTIC,
            _ => closed_form::solve(law, q),
        };
        law.accept(&outcome.unloading.peak)?;
        Essentials::new(self, speed, &scales, law, &outcome)
    }

    /// Integrates one impact at `speed` \[m/s\]; with `samples`, records a trace of that many evenly spaced rows (first
    /// touch and separation among them) and a row for every other event.
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision or the integrator gives up.
    pub fn impact(&self, speed: f64, solver: &Solver, samples: Option<usize>) -> Result<Impact, ImpactError> {
        if !self.forces.is_none() {
            return self.impact_with_forces(speed, solver, samples);
        }
        let (scales, law, q) = self.scaled(speed)?;
        self.impact_by(&scales, law, q, speed, solver, samples).map(|(impact, _)| impact)
    }

    /// The impact and its dimensionless outcome, by the law of the place.
    fn impact_by(
        &self,
        scales: &Scales,
        law: &Law,
        q: f64,
        speed: f64,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Impact, Outcome), ImpactError> {
        let exact = closed_form::solve(law, q);
        law.accept(&exact.unloading.peak)?;
        let mut recorder = samples.map(|samples| Recorder::new(samples, exact.contact_time));
        let method = match (solver.method, samples) {
            (Method::Auto, None) => Method::ClosedForm,
            (Method::Auto, Some(_)) => Method::Rk8,
            (method, _) => method,
        };
        let (outcome, work) = run(law, q, &exact, &Solver { method, ..*solver }, recorder.as_mut())?;
        let points = recorder.map_or_else(Vec::new, |recorder| recorder.points);
        let mut impact = Impact::new(self, speed, method, scales, law, &outcome, &exact, work, &points)?;
        if method != Method::Verlet {
            validity::check_accuracy(&mut impact, solver.tolerance);
        }
        Ok((impact, outcome))
    }
}

/// Hertz without end: the law of every impact that stays elastic, in its own units.
fn hertz() -> &'static Law {
    static HERTZ: LazyLock<Law> = LazyLock::new(Law::hertz);
    &HERTZ
}
