//! The uncertainty interval of a dent.

use crate::units::{Dimension, quantities};

/// Both ends of diameter and depth of a dent \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DentInterval {
    pub diameter: [f64; 2],
    pub depth: [f64; 2],
}

impl DentInterval {
    /// Both ends of the diameter, with a unit.
    pub fn diameter_text(&self) -> String {
        length_range(&self.diameter)
    }

    /// Both ends of the depth, with a unit.
    pub fn depth_text(&self) -> String {
        length_range(&self.depth)
    }
}

fn length_range(ends: &[f64; 2]) -> String {
    quantities(ends, Dimension::Length).join(" to ")
}
