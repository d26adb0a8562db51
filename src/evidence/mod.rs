//! The law against reality, and speed against error.

pub mod bench;
pub mod validate;
