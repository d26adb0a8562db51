//! A half-space that is indented, with what came of it.

use super::Indentation;
use crate::contact::material::{HalfSpace, Pair};

/// A half-space that is indented.
#[derive(Debug, Clone, PartialEq)]
pub struct Specimen {
    /// Its name among several; `None` for a single one.
    pub name: Option<String>,
    /// What is indented.
    pub half_space: HalfSpace,
}

/// One half-space with what came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Tested {
    /// The half-space.
    pub specimen: Specimen,
    /// What its pairing with the sphere fixes.
    pub pair: Pair,
    /// Whether a load that is large enough leaves a dent.
    pub can_yield: bool,
    /// The results.
    pub indentation: Indentation,
}
