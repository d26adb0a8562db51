//! Tests of the command and its files: scenarios, messages, reports, pictures, evaluation of measurements.

#![allow(clippy::unwrap_used)]

mod calibrate;
#[path = "../common/mod.rs"]
mod common;
mod interfaces;
mod report;
mod scenario;
mod validate;
