//! How the program knows a file that it wrote without a summary that lists it: by the beginning.

use std::fs::File;
use std::io::{self, Read as _};
use std::ops::Range;
use std::path::Path;

/// The most bytes of a first line that are compared.
const MAX_LINE: usize = 4096;
/// The parts of a PNG file that name its form, with no text or other chunk before the pixels: the mark of the format with the first
/// chunk, and the name of the second chunk.
const PNG_PARTS: [Range<usize>; 2] = [0..33, 37..41];
const PNG_MARK: &[u8] = b"\x89PNG\r\n\x1a\n";

/// True if a file begins as this new one does: a text with the same first line, a PNG of the same size and form. Of other formats
/// all bytes have to be the same.
///
/// # Errors
/// [`io::Error`] if the file cannot be read.
pub fn begins_like(path: &Path, new: &[u8]) -> io::Result<bool> {
    let parts = match new.iter().position(|byte| *byte == b'\n') {
        _ if new.starts_with(PNG_MARK) => PNG_PARTS,
        Some(end) if std::str::from_utf8(new).is_ok() => [0..MAX_LINE.min(end + 1), 0..0],
        // a longer file has one byte more
        _ => [0..new.len() + 1, 0..0],
    };
    let length = parts.iter().map(|part| part.end).max().unwrap_or(0);
    let mut old = Vec::new();
    File::open(path)?.take(length as u64).read_to_end(&mut old)?;
    Ok(parts.into_iter().all(|part| part_of(&old, &part) == part_of(new, &part)))
}

/// The bytes in a range; fewer if the text ends before the range does.
fn part_of<'a>(bytes: &'a [u8], range: &Range<usize>) -> &'a [u8] {
    &bytes[range.start.min(bytes.len())..range.end.min(bytes.len())]
}
