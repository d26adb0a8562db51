//! Files of this folder.

pub mod flow;
pub mod random;
pub mod same_spot;
