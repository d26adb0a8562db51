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

mod compute;
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

impl Contact {
    /// Computes one impact on fresh surface, or in a dent. Returns the impact, and the surface and the unloading branch that it ends on.
    fn impact_on_surface<'a>(
        &'a self,
        dent: Option<&'a LoadingHistory>,
        approach: Approach,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Impact, Surface<'a>, Unloading), ImpactError> {
        let problem = self.scaled_impact(dent, approach.normal)?;
        let solver = self.resolve_solver(solver, samples.is_some())?;
        let (exact, solution) = problem.solve(&solver, samples)?;
        let unloading = solution.outcome.unloading;
        let mut impact = Impact::new(self, approach.normal, &problem, solver.method, &solution, exact.as_ref())?;
        impact.warnings = warnings::impact_warnings(self, &impact, problem.ground, &unloading, &solver);
        if let Some(oblique) = ObliqueImpact::new(self, &problem, &solution.outcome, approach)? {
            impact.add_friction(&oblique, approach)?;
            impact.warnings.extend(warnings::oblique_warnings(self, &impact, approach));
        }
        Ok((impact, problem.ground, unloading))
    }
}
