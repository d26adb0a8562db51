//! Texts for the user: warnings, refusals and the inputs in a summary, from the command as a process.

mod inputs;
mod types;
mod warnings;
