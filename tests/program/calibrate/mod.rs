//! Tests of calibrations.

pub mod bounce_intervals;
pub mod comparison;
pub mod coverage;
pub mod files;
pub mod fits;
pub mod limits;
pub mod plate;
pub mod statistics;
pub mod table;
