//! A contact without time: two bodies, the strengths at which they yield, and the laws of force and dent.

pub mod law;
pub mod material;
pub mod materials;
pub mod strength;
