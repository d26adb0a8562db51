//! The uncertainty interval of a dent.

use crate::units::{Dimension, quantities};

/// Both ends of diameter and depth of a dent \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DentInterval {
    pub diameter: [f64; 2],
    pub depth: [f64; 2],
}

impl DentInterval {
    /// Both ends of a length in words.
    pub fn text(ends: [f64; 2]) -> String {
        quantities(&ends, Dimension::Length).join(" to ")
    }
}
