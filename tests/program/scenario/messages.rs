//! Texts for the user: warnings and refusals, from the command as a process.

mod value_types;
mod warnings;
