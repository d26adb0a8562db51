//! What the program says to a person: warnings, refusals and the inputs in a summary, through the command as a process.

mod inputs;
mod types;
mod warnings;
