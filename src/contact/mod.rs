//! A contact without time: two bodies, their strengths, and the laws of force and dent.

pub mod body;
pub mod law;
pub mod pair;
pub mod strength;
