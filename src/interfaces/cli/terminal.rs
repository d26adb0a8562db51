//! Writes to the terminal: results to standard output, errors, warnings and notes to standard error, in colour
//! where a terminal shows it, or for programs as JSON.

use std::fmt::Display;
use std::io::{self, Write as _};
use std::sync::atomic::{AtomicBool, Ordering};

use clap::ValueEnum;
use clap::builder::styling::{AnsiColor, Style};
use plm_impact::error::{Details, Error};
use serde::Serialize;

/// How errors, warnings and notes are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ErrorFormat {
    Text,
    Json,
}

/// Programs read the errors then.
static IS_JSON: AtomicBool = AtomicBool::new(false);

impl ErrorFormat {
    /// Errors are written in this format from now on.
    pub fn install(self) {
        IS_JSON.store(self == Self::Json, Ordering::Relaxed);
    }
}

/// Writes the error that ends the program; gives the exit code.
pub fn error(error: &Error) -> u8 {
    let exit_code = error.exit_code();
    write_line("error", Some(AnsiColor::Red), Some(exit_code), error.to_string(), (*error.details).clone());
    exit_code
}

/// Adds to an error of the system what failed, for `map_err`.
pub fn failed_with<E: Display>(failure: impl Display) -> impl FnOnce(E) -> Error {
    move |reason| Error::failed(format!("{failure}: {reason}"))
}

/// Writes a warning.
pub fn warning(text: impl Display) {
    write_line("warning", Some(AnsiColor::Yellow), None, text.to_string(), Details::default());
}

/// Writes a note.
pub fn note(text: impl Display) {
    write_line("note", None, None, text.to_string(), Details::default());
}

pub fn is_json() -> bool {
    IS_JSON.load(Ordering::Relaxed)
}

/// An object for a program.
#[derive(Serialize)]
struct Diagnostic<'a> {
    level: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    exit_code: Option<u8>,
    #[serde(flatten)]
    details: Details,
}

/// A line to standard error, which begins with the level if that has a colour; or an object for a program, with `text` where
/// the details have no message. A line that nobody reads (`2>&1 | head`) is no failure.
fn write_line(level: &str, color: Option<AnsiColor>, exit_code: Option<u8>, text: String, mut details: Details) {
    if is_json() {
        details.message.get_or_insert(text);
        // texts and numbers are always JSON
        let object = serde_json::to_string(&Diagnostic { level, exit_code, details }).unwrap_or_default();
        drop(writeln!(io::stderr().lock(), "{}", escape_control_json(&object)));
        return;
    }
    let begin = color.map_or_else(String::new, |color| {
        let style = Style::new().bold().fg_color(Some(color.into()));
        format!("{style}{level}:{style:#} ")
    });
    drop(writeln!(anstream::stderr().lock(), "{begin}{}", escape_control(&text)));
}

/// The text without control characters, which names of files and keys may hold and which a terminal obeys.
fn escape_control(text: &str) -> String {
    escape_with(text, |c| c.escape_default().to_string())
}

/// Escapes control characters of JSON, where they stand in texts alone.
fn escape_control_json(text: &str) -> String {
    escape_with(text, |c| format!("\\u{:04x}", u32::from(c)))
}

fn escape_with(text: &str, escape: fn(char) -> String) -> String {
    let is_obeyed = |c: char| c.is_control() && c != '\n' && c != '\t';
    text.chars().map(|c| if is_obeyed(c) { escape(c) } else { c.to_string() }).collect()
}

/// Prints a result; a reader that has seen enough (`| head`) is no failure.
pub fn print(text: &str) -> Result<(), Error> {
    write_stdout(&escape_control(text))
}

pub fn print_json(text: &str) -> Result<(), Error> {
    write_stdout(&escape_control_json(text))
}

fn write_stdout(text: &str) -> Result<(), Error> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result.map_err(failed_with("standard output")),
    }
}
