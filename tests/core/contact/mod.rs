//! Tests of the contact laws.

pub mod hardening;
pub mod laws;
pub mod plm;
pub mod reloading;
pub mod unloading_exponent;
pub mod yielding_bodies;
