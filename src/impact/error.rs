//! Why an impact has no result.

use thiserror::Error;

use super::plate::PlateError;
use crate::error::{Error as Failure, ErrorKind};
use crate::integrate::IntegrationError;
use crate::law::OutsideLaw;
use crate::material::OutOfFloatRange;

#[derive(Debug, Clone, PartialEq, Error)]
pub enum ImpactError {
    #[error(transparent)]
    Range(#[from] OutOfFloatRange),
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The law has no answer for this impact.
    #[error(transparent)]
    Law(#[from] OutsideLaw),
    /// There is no impact on such a plate.
    #[error(transparent)]
    Plate(#[from] PlateError),
    /// No closed form for this scene.
    #[error("method \"closed_form\" has no answer under damping and on a plate: use \"auto\" or \"rk8\"")]
    NoClosedForm,
}

impl From<ImpactError> for Failure {
    fn from(error: ImpactError) -> Self {
        Self::of(ErrorKind::Failed, &error)
    }
}
