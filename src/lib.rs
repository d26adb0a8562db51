//! Low-velocity impact of an elastic sphere on an elastic-plastic half-space.

pub mod bench;
pub mod impact;
pub mod integrate;
pub mod law;
pub mod material;
pub mod power;
