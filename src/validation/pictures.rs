//! Pictures of the comparison.

use super::ValidationError;
use crate::law::PlmCoefficients;
use crate::output::OutputFile;

/// All pictures.
///
/// # Errors
/// [`ValidationError`].
pub fn pictures(_coefficients: &PlmCoefficients) -> Result<Vec<OutputFile>, ValidationError> {
    Ok(Vec::new())
}
