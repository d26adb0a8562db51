//! Texts for the user: warnings and refusals, from the command as a process.

mod types;
mod warnings;
