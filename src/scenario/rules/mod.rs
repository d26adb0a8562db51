//! Which keys may stand together.

pub(in crate::scenario) mod combinations;
pub mod effect;
pub(in crate::scenario) mod flow_curve;
pub(in crate::scenario) mod strain_rate;
mod unused_keys;
