//! One file for each kind of scenario.

pub mod calibration;
pub mod indentation;
pub mod inverse;
pub(in crate::scenario) mod series;
pub(in crate::scenario) mod sweep;
