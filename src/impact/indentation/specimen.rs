//! A half-space that is indented, and its results.

use super::Indentation;
use crate::contact::material::{HalfSpace, Pair};

/// A half-space that is indented.
#[derive(Debug, Clone, PartialEq)]
pub struct Specimen {
    /// Its name among several; `None` for a single one.
    pub name: Option<String>,
    /// The half-space that is indented.
    pub half_space: HalfSpace,
}

/// One half-space and its results.
#[derive(Debug, Clone, PartialEq)]
pub struct Tested {
    /// The half-space.
    pub specimen: Specimen,
    /// The sphere and this half-space as a pair.
    pub pair: Pair,
    /// True if a load that is large enough leaves a dent.
    pub can_yield: bool,
    /// The results.
    pub indentation: Indentation,
}
