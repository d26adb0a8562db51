//! How the program knows a file that it wrote without a summary that lists it: by the beginning.

use std::fs::File;
use std::io::{self, Read as _};
use std::path::Path;

/// The most bytes of a first line that are compared.
const MAX_LINE: usize = 4096;
/// The bytes of a PNG file before the pixels: mark of the format, size and form, and the text with the name of the program.
const PNG_HEAD: usize = 64;
const PNG_MARK: &[u8] = b"\x89PNG\r\n\x1a\n";

/// True if a file begins as this new one does: a text with the same first line, a PNG of the same size and form with the name of
/// the program. Of other formats all bytes must be the same.
///
/// # Errors
/// [`io::Error`] if the file cannot be read.
pub fn begins_like(path: &Path, new: &[u8]) -> io::Result<bool> {
    let length = match new.iter().position(|byte| *byte == b'\n') {
        _ if new.starts_with(PNG_MARK) => PNG_HEAD,
        Some(end) if std::str::from_utf8(new).is_ok() => MAX_LINE.min(end + 1),
        // a longer file has one byte more
        _ => new.len() + 1,
    };
    let mut old = Vec::new();
    File::open(path)?.take(length as u64).read_to_end(&mut old)?;
    Ok(old == new[..length.min(new.len())])
}
