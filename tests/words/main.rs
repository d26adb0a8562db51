//! What the program says to a person: warnings, refusals and the inputs in a summary, through the command as a process.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;
mod inputs;
mod types;
mod warnings;
