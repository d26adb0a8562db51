//! Which keys may stand together, and which have no effect.

pub(in crate::scenario) mod combinations;
pub mod effect;
pub(in crate::scenario) mod flow_curve;
pub(in crate::scenario) mod strain_rate;
mod unused_keys;
