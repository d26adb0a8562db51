//! Tests of the library: laws, steppers, impacts, series and indentation, compared with closed forms, conservation laws
//! and references.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod air;
mod cases;
mod damped;
mod exponent;
mod flow_stress;
mod forces;
mod hard_cases;
mod hardening;
mod hertz;
mod indentation;
mod interval;
mod invalid_input;
mod landing;
mod law;
mod laws;
mod oblique;
mod plate;
mod rate;
mod references;
mod reloading;
mod repeat;
mod two_bodies;
mod universe;
mod verlet;
mod waves;
mod yield_point;
mod yielding;
