//! The impact of a sphere on a half-space: its motion, its end, and its results.
//!
//! A [`Contact`] is the part of an impact that does not depend on the speed (bodies, law, scales). [`Contact::impact`] computes one
//! impact, [`Contact::closed_form`] computes the exact outcome without integration. The interface uses SI units, and the inside
//! dimensionless numbers.
//!
//! The files depend on each other in this order: what acts ([`scales`], [`plate`], [`forces`]); the dimensionless result
//! ([`record`], [`outcome`]); how it is computed ([`closed_form`], [`course`], [`verlet`], [`solve`]); what is reported of it
//! ([`contact`], `rate`, `case`, [`oblique`], [`essentials`], `ledger`, [`result`], `bodies`, `validity`); the impacts of a contact (`impacts`,
//! [`spot`]); the law as a force of its own (`response`, [`friction`]); and this file, which only names them.

pub mod air;
mod bodies;
mod case;
pub mod closed_form;
pub mod contact;
pub mod course;
mod error;
pub mod essentials;
pub mod forces;
pub mod friction;
mod impacts;
pub mod indentation;
mod ledger;
pub mod oblique;
pub mod outcome;
pub mod plate;
mod rate;
pub mod record;
#[doc(hidden)]
pub mod reference;
pub mod repeat;
mod response;
pub mod result;
pub mod scales;
pub mod solve;
pub mod spot;
mod validity;
pub mod verlet;
mod warning;
pub mod waves;

pub use bodies::{TOO_HIGH, TOO_HIGH_BY};
pub(crate) use bodies::{left_out, of_elastic, of_flow, of_half_space, of_sphere, of_yielding};
pub use contact::{Contact, Named, Rated};
pub use error::ImpactError;
pub use essentials::{Essentials, OnPlate};
pub use forces::{Damping, Forces, STANDARD_GRAVITY, ScaledForces};
pub use friction::FrictionStep;
pub use ledger::TraceRow;
pub use oblique::{Approach, FrictionState, Incidence, Oblique, Rebound};
pub use outcome::{Computed, Fate, FixedSteps, Outcome};
pub use plate::{Plate, PlateError, PlateTheory};
pub use record::{Event, Point, Recorder};
pub use response::{ContactEnergy, Memory};
pub use result::{Accuracy, Energy, ForcesResult, Impact};
pub use scales::Scales;
pub use solve::{Method, Solver, run};
pub use spot::Spot;
pub use validity::Bias;
pub(crate) use validity::{of_dent, of_exponent, of_peak};
pub use warning::{Warning, WarningKind};
