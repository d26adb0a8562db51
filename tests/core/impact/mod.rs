//! Tests of impacts, series and indentation.

pub mod adhesion;
pub mod deep_dents;
pub mod flight;
pub mod forces;
pub mod hardening_scenarios;
pub mod hertz;
pub mod indentation;
pub mod interval;
pub mod invalid_input;
pub mod oblique;
pub mod plate;
mod pulse;
mod rate;
pub mod references;
mod rod;
pub mod series;
pub mod stability;
pub mod stability_cases;
pub mod steps;
pub mod strain_rate;
pub mod two_bodies;
pub mod verlet;
pub mod viscoelastic;
pub mod waves;
pub mod yield_point;
