//! Tests of the library: laws, steppers, impacts, series and indentation, compared with closed forms, conservation laws
//! and references.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;
mod contact;
mod impact;
mod numerics;
mod properties;
