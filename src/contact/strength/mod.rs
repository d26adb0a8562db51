//! The strength of metals, given as a flow curve or as a hardness, and how it rises with the rate of strain.

pub mod flow_curve;
pub mod hardness;
pub mod kind;
pub mod strain_rate_hardening;
