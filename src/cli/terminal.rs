//! What is written to the terminal.

use std::fmt::Display;
use std::io::{self, Write as _};

use anyhow::Context as _;

/// A line to standard error; one that nobody reads (`2>&1 | head`) is no failure.
pub fn note(line: impl Display) {
    drop(writeln!(io::stderr().lock(), "{}", harmless(&line.to_string())));
}

/// The text without control characters, which names of files and keys may hold and which a terminal obeys.
fn harmless(text: &str) -> String {
    let is_obeyed = |c: char| c.is_control() && c != '\n' && c != '\t';
    text.chars().fold(String::with_capacity(text.len()), |mut shown, c| {
        if is_obeyed(c) {
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
        shown
    })
}

/// Prints a result; a reader that has seen enough (`| head`) is no failure.
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(harmless(text).as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result.context("standard output"),
    }
}
