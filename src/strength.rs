//! The strength of metals in the forms that people have it: flow curves and hardness.

pub mod flow;
pub mod hardness;
