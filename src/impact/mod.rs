//! The impact of a sphere on a half-space: its motion, its end, and its results.
//!
//! A [`Contact`] is the part of an impact that does not depend on the speed (bodies, law, scales). [`Contact::impact`] computes one
//! impact, [`Contact::closed_form`] computes the exact outcome without integration. The interface uses SI units, and the inside
//! dimensionless numbers.
//!
//! The files depend on each other in this order: what acts ([`problem::scales`], [`problem::plate`], [`problem::forces`]); the dimensionless result
//! ([`solve::recorder`], [`solve::outcome`]); how it is computed ([`solve::closed_form`], [`solve::motion`], [`solve::verlet`], [`solve`]); what is reported of it
//! ([`problem::contact`], `rate`, `case`, [`oblique`], [`result::row`], `ledger`, [`result::impact`], `bodies`, `validity`); the impacts of a contact (`impacts`,
//! [`series::spot`]); the law as a force of its own (`response`, [`dem::friction`]); and this file, which only names them.

mod compute;
pub mod dem;
pub mod flight;
pub mod indentation;
pub mod oblique;
pub mod problem;
pub mod result;
mod scaled_impact;
pub mod series;
pub mod solve;
mod warnings;

pub use dem::force::{ContactEnergy, Memory};
pub use dem::friction::FrictionStep;
pub use oblique::{Approach, FrictionState, Incidence, ObliqueResult, Rebound};
pub use problem::contact::{Contact, MaterialNames, StrainRateResult};
pub use problem::error::ImpactError;
pub use problem::forces::{Damping, Forces, STANDARD_GRAVITY, ScaledForces};
pub use problem::plate::{Plate, PlateError, PlateTheory};
pub use problem::scales::Scales;
pub use result::energy_balance::TraceRow;
pub use result::impact::{Accuracy, Energy, ForcesResult, Impact};
pub use result::row::{ImpactRow, PlateResult};
pub use result::warning::{Warning, WarningKind};
pub use series::spot::Spot;
pub use solve::outcome::{FixedSteps, ImpactEnd, ScaledResult, Solution};
pub use solve::recorder::{Event, TracePoint, TraceRecorder};
pub use solve::{Method, Solver, solve};
pub use warnings::Bias;
pub use warnings::bodies::{RESTITUTION_BIAS_TEXT, TOO_HIGH_BY};
pub(crate) use warnings::bodies::{
    elastic_material_warning, flow_warnings, half_space_warnings, ignored_strength, sphere_warnings, yielding_warning,
};
pub(crate) use warnings::{dent_warning, exponent_warning, peak_warnings};
