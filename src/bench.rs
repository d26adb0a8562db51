//! What integrators are measured on: problems with exact solutions, and cases that break careless ones.

pub mod hard_cases;
pub mod measure;
pub mod problems;
pub mod report;
