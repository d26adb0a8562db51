//! Results in SI: row, impact, energy balance, warning type.

pub(in crate::impact) mod energy_balance;
pub mod impact;
pub mod row;
pub mod subsurface;
pub(in crate::impact) mod warning;
pub mod waveguide;
