//! Tests of scenarios: keys, messages, refusals.

pub mod check_messages;
pub mod edit;
pub mod indentation;
pub mod init;
pub mod interval;
pub mod keys;
pub mod material_keys;
pub mod materials;
pub mod messages;
pub mod rate_keys;
pub mod reading;
pub mod refusals;
pub mod results;
pub mod series;
pub mod strength_keys;
pub mod units;
pub mod warning_order;
pub mod warnings;
