//! The impact of a sphere on a half-space: its motion, its end, and its results.
//!
//! A [`Contact`] is the part of an impact that does not depend on the speed (bodies, law, scales). [`Contact::impact`] computes one
//! impact, [`Contact::closed_form`] computes the exact outcome without integration. The interface uses SI units, and the inside
//! dimensionless numbers.
//!
//! The way of one impact is the code of this file, `Contact::impact_on_surface`: a folder for each of its steps.
//!
//! 1. [`problem`] makes the impact dimensionless: contact, scales, forces, plate and rod, strain rate.
//! 2. [`solve`](mod@solve) computes the normal motion: by its closed form, by integration along the pieces of the law, or in fixed steps.
//! 3. [`result`] gives the results in SI units, and `warnings` checks the model and the run.
//! 4. [`oblique`] adds the tangential motion of an impact with friction.
//!
//! [`pulse`] samples the force as a source for waves. [`series`] has impacts one after the other with [`flight`] between them. [`indentation`] has contacts without motion, and [`dem`] has
//! force and friction for codes that move the spheres themselves.

pub mod dem;
pub mod flight;
pub mod indentation;
pub mod oblique;
pub mod problem;
pub mod pulse;
pub mod result;
mod scaled_impact;
pub mod series;
pub mod solve;
mod warnings;

pub use dem::force::{ContactEnergy, Memory};
pub use dem::friction::FrictionStep;
pub use dem::step::ContactHistory;
pub use oblique::{Approach, CrossMotion, FrictionState, ObliqueResult, Rebound, TangentialMotion};
pub use problem::adhesion::AdhesionResult;
pub use problem::contact::{Contact, MaterialNames, StrainRateResult};
pub use problem::error::ImpactError;
pub use problem::forces::{Damping, Forces, STANDARD_GRAVITY, ScaledForces};
pub use problem::peening::{PeenedSurface, Peening};
pub use problem::plate::{Plate, PlateTheory};
pub use problem::rod::Rod;
pub use problem::scales::Scales;
pub use problem::waveguide::{Waveguide, WaveguideError, WaveguideFault, WaveguideKind};
pub use pulse::{Pulse, PulseError, PulseRequest};
pub use result::energy_balance::TraceRow;
pub use result::impact::{Accuracy, Energy, ForcesResult, Impact};
pub use result::row::ImpactRow;
pub use result::subsurface::Subsurface;
pub use result::warning::{Warning, WarningKind};
pub use result::waveguide::WaveguideResult;
pub use series::spot::Spot;
pub use solve::outcome::{FixedSteps, ImpactEnd, ScaledResult, Solution};
pub use solve::recorder::{Event, TracePoint, TraceRecorder};
pub use solve::{Method, Solver, solve};
pub use warnings::Bias;
pub use warnings::bodies::{RESTITUTION_BIAS_TEXT, TOO_HIGH_BY};
pub(crate) use warnings::bodies::{
    elastic_material_warning, flow_warnings, half_space_warnings, ignored_strength, sphere_warnings, yielding_warning,
};
pub use warnings::limits;
pub(crate) use warnings::{dent_warning, exponent_warning, peak_warnings};

use crate::contact::law::{LoadingHistory, Surface, Unloading};
use oblique::ObliqueImpact;
use scaled_impact::ScaledImpact;
use solve::{TRACE_TOLERANCE, closed_form};

impl Contact {
    /// Computes one impact at a speed \[m/s\], or an [`Approach`]; with `samples`, with a trace of that many evenly
    /// spaced rows (first contact and separation among them) and a row for every other event.
    ///
    /// # Errors
    /// [`ImpactError`] if the result leaves double precision or the integrator fails.
    pub fn impact(
        &self,
        approach: impl Into<Approach>,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<Impact, ImpactError> {
        let approach = approach.into();
        let rated = self.at_speed(approach.normal)?;
        rated.impact_on_surface(None, approach, solver, samples).map(|(impact, ..)| impact)
    }

    /// Computes one impact on fresh surface, or in a dent. Returns the impact, and the surface and the unloading branch that it ends on.
    fn impact_on_surface<'a>(
        &'a self,
        dent: Option<&'a LoadingHistory>,
        approach: Approach,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Impact, Surface<'a>, Unloading), ImpactError> {
        let problem = self.scaled_impact(dent, approach.normal)?;
        let ScaledImpact { ground, q, forces, .. } = problem;
        let solver = self.resolve_solver(solver, samples.is_some())?;
        let tolerance = if solver.method == Method::ClosedForm { solver.tolerance } else { TRACE_TOLERANCE };
        let exact = closed_form::solve_conservative(ground, q, &forces, tolerance)?;
        let solution = solve(ground, q, &forces, exact.as_ref(), &solver, samples)?;
        let unloading = solution.outcome.unloading;
        ground.check(&unloading)?;
        let mut impact = Impact::new(self, approach.normal, &problem, solver.method, &solution, exact.as_ref())?;
        impact.warnings = warnings::impact_warnings(self, &impact, ground, &unloading, &solver);
        if let Some(oblique) = ObliqueImpact::new(self, &problem, &solution.outcome, approach)? {
            impact.add_friction(&oblique, approach)?;
            impact.warnings.extend(warnings::oblique_warnings(self, &impact, approach));
        }
        Ok((impact, ground, unloading))
    }

    /// The solver with the method that computes an impact of this contact.
    #[inline]
    fn resolve_solver(&self, solver: &Solver, has_trace: bool) -> Result<Solver, ImpactError> {
        let method = solver.method.resolve(self.forces(), has_trace).ok_or(ImpactError::NoClosedForm)?;
        Ok(Solver { method, ..*solver })
    }

    /// The exact outcome of an impact, without integration; under gravity its times are accurate to 1e-13.
    ///
    /// # Errors
    /// [`ImpactError::Range`], see [`Contact::scaling`]; [`ImpactError::NoClosedForm`] under damping, and on a plate or rod.
    pub fn closed_form(&self, speed: f64) -> Result<Impact, ImpactError> {
        let solver = Solver { method: Method::ClosedForm, tolerance: TRACE_TOLERANCE, ..Solver::default() };
        self.impact(speed, &solver, None)
    }

    /// The results of an impact for a row of a table, computed by this solver.
    ///
    /// # Errors
    /// [`ImpactError`] if the result leaves double precision, the law has no answer, the integrator fails, or the method is not
    /// possible.
    #[inline]
    pub fn row(&self, approach: impl Into<Approach>, solver: &Solver) -> Result<ImpactRow, ImpactError> {
        let approach = approach.into();
        // to move the `Cow` of `at_speed` would take a tenth of the time of a row
        if self.has_rate() {
            self.at_speed(approach.normal)?.row_at(approach, solver)
        } else {
            self.row_at(approach, solver)
        }
    }

    #[inline]
    fn row_at(&self, approach: Approach, solver: &Solver) -> Result<ImpactRow, ImpactError> {
        let problem = self.scaled_impact(None, approach.normal)?;
        let ScaledImpact { ground, q, forces, .. } = problem;
        let outcome = match self.resolve_solver(solver, false)?.method {
            Method::ClosedForm => closed_form::solve_conservative(ground, q, &forces, solver.tolerance)?,
            _ => None,
        };
        let outcome = match outcome {
            Some(outcome) => outcome,
            None => solve(ground, q, &forces, None, solver, None)?.outcome,
        };
        ground.check(&outcome.unloading)?;
        let mut row = ImpactRow::new(self, approach.normal, &problem, &outcome)?;
        if let Some(oblique) = ObliqueImpact::new(self, &problem, &outcome, approach)? {
            row.rebound = Some(oblique.rebound(&oblique.slip_result(false)?)?);
        }
        Ok(row)
    }
}
