//! The problems on which the integrators are measured, with exact solutions, and the hard cases on which they are tested.

pub mod hard_cases;
pub mod laws;
pub mod measure;
pub mod problems;
pub mod report;
pub mod throughput;
