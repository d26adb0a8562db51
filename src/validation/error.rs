//! Errors of references, which are compiled in, and the exponents that are compared.

use crate::error::{Error, ErrorKind};
use crate::impact::ImpactError;
use crate::law::UnloadingExponent;
use crate::material::OutOfFloatRange;

impl From<ImpactError> for Error {
    fn from(error: ImpactError) -> Self {
        Self::of(ErrorKind::Failed, &error)
    }
}

impl From<OutOfFloatRange> for Error {
    fn from(error: OutOfFloatRange) -> Self {
        Self::of(ErrorKind::Failed, &error)
    }
}

/// A reference curve or scenario that is damaged.
pub(super) fn damaged(what: &str) -> impl Fn(Error) -> Error {
    move |error| Error::failed(format!("reference {what} {error}"))
}

/// The exponents that are compared, with their names in tables and pictures.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::Paper, "exponent 3/2"), (UnloadingExponent::PressureShape, "pressure-shape")];
