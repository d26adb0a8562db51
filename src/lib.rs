//! Low-velocity impact of an elastic sphere on an elastic-plastic half-space.

pub mod error;
pub mod impact;
pub mod integrate;
pub mod law;
pub mod material;
pub mod nearest;
pub mod power;
pub mod scenario;
pub mod sweep;
pub mod units;
