//! Tests of the command and its files: scenarios, messages, reports, pictures, evaluation of measurements.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod bench;
mod calibrate;
mod cli;
mod coefficients;
mod doubts;
mod drawn;
mod drop;
mod edit;
mod export;
mod holds;
mod hostile_input;
mod indentation_cli;
mod init;
mod interval;
mod keys;
mod laws;
mod licences;
mod marks;
mod material_keys;
mod materials;
mod other_pictures;
mod picture_numbers;
mod picture_words;
mod pictures;
mod plots;
#[cfg(unix)]
mod programs;
mod rate_keys;
mod refusals;
mod repeat_cli;
mod report;
mod says;
mod scenario;
mod second;
mod several;
mod strength_keys;
mod units;
mod validation;
mod words;
