//! The definition of an impact: contact, scales, forces, adhesion, plate and rod, waves, strain rate, errors.

pub mod adhesion;
pub mod contact;
pub(in crate::impact) mod error;
pub mod forces;
pub mod peening;
pub mod plate;
pub mod rod;
pub mod scales;
pub(in crate::impact) mod strain_rate;
pub mod waveguide;
pub mod waves;
