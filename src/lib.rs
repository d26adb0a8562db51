//! Low-velocity impact of an elastic sphere on an elastic-plastic half-space.

pub mod bench;
pub mod error;
pub mod impact;
pub mod integrate;
pub mod law;
pub mod material;
pub mod nearest;
pub mod output;
pub mod plot;
pub mod power;
pub mod report;
pub mod run;
pub mod scenario;
pub mod sweep;
pub mod units;
