//! The strength of metals, given as a flow curve or as a hardness.

pub mod flow;
pub mod hardness;
