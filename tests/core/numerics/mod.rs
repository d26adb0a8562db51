//! Tests of the numerical methods.

pub mod damped_integrators;
pub mod landing;
