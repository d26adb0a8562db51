//! Force and friction for codes that move the spheres themselves.

pub(in crate::impact) mod force;
pub mod friction;
pub mod step;
