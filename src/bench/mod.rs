//! The problems on which the integrators are measured, with exact solutions.

pub mod laws;
pub mod measure;
pub mod problems;
pub mod report;
pub mod throughput;
