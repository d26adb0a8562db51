//! Why an impact has no result.

use thiserror::Error;

use super::plate::PlateError;
use crate::error::{Error as Failure, ErrorKind};
use crate::integrate::IntegrationError;
use crate::law::OutsideLaw;
use crate::material::OutOfFloatRange;

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
    /// There is no impact on such a plate.
    #[error(transparent)]
    Plate(#[from] PlateError),
    /// No closed form for this scene.
    #[error(
        "method \"closed_form\" gives no trace under gravity or damping, and nothing on a plate; without a trace it gives gravity alone or Hunt-Crossley damping alone, on laws whose force is made of power laws and straight lines: use \"auto\" or \"rk8\""
    )]
    NoClosedForm,
}

impl From<ImpactError> for Failure {
    fn from(error: ImpactError) -> Self {
        Self::of(ErrorKind::Failed, &error)
    }
}
