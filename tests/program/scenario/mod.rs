//! Tests of scenarios: keys, messages, refusals.

pub mod edit;
pub mod expectations;
pub mod indentation;
pub mod init;
pub mod interval;
pub mod keys;
pub mod material_keys;
pub mod materials;
pub mod rate_keys;
pub mod reading;
pub mod series;
pub mod strength_keys;
pub mod units;
pub mod warning_order;
pub mod warnings;
