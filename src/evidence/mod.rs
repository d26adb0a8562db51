//! How good the program is: `validate` compares the law with reality, and `bench` measures speed against error.

pub mod bench;
pub mod validate;
