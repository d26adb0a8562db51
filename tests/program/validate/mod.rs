//! Tests of validation and benchmark.

pub mod bench;
pub mod coefficients;
pub mod comparison_page;
pub mod independent_law;
pub mod validation;
