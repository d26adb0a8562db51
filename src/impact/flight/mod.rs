//! Free flight in air or vacuum.

pub mod free_flight;
pub mod trajectory;
