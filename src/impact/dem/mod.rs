//! Force and friction for codes that move the spheres themselves.

pub(in crate::impact) mod force;
pub mod friction;
pub mod law_table;
pub mod step;
