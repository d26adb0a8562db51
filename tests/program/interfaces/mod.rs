//! Tests of the command line and of exports.

mod check_trace;
pub mod cli;
pub mod drop;
mod engines;
pub mod export;
mod export_two_spheres;
mod find;
mod header;
pub mod hostile_input;
#[cfg(unix)]
pub mod json_and_shell;
pub mod laws;
pub mod licences;
mod material_codes;
pub mod mutated_files;
mod peen;
pub mod several_files;
