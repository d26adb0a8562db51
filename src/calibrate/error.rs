//! Why a law predicts nothing of what was measured.

use crate::impact::ImpactError;
use crate::indentation::IndentationError;

/// Why the law predicts nothing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoAnswer {
    /// An impact has no result.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// An indentation has no result.
    #[error(transparent)]
    Indentation(#[from] IndentationError),
    /// The sphere stays in its dent, so a measured quantity such as the contact time does not exist.
    #[error("a quantity that was measured does not exist there, as the sphere does not leave")]
    Captured,
}
