//! Widths of texts, with the same bits for every format and on every machine, and what follows from them: sizes and lines.

use std::sync::LazyLock;

use ab_glyph::{Font as _, FontRef, ScaleFont as _};

use super::PlotError;

/// The font of the pictures without its shapes; `text/build.rs` makes it.
static FONT: LazyLock<Option<FontRef>> =
    LazyLock::new(|| FontRef::try_from_slice(include_bytes!(concat!(env!("OUT_DIR"), "/widths.ttf"))).ok());

/// Widths are whole numbers of these pieces of a pixel, as plotters measures the letters of a PNG.
const PIECES: f64 = 2.0;

/// Width of a text in the font of the pictures \[px\]: the sum of the advances of its letters, and of the kerning between them.
#[allow(clippy::cast_possible_truncation)] // texts of some thousand pixels, measured in single precision
pub fn text_width(text: &str, size: f64) -> Result<f64, PlotError> {
    let font = FONT.as_ref().ok_or(PlotError::Font)?.as_scaled((PIECES * size) as f32);
    let (mut width, mut before) = (0.0_f32, None);
    for letter in text.chars().map(|letter| font.glyph_id(letter)) {
        width += font.h_advance(letter);
        width += before.map_or(0.0, |before| font.kern(before, letter));
        before = Some(letter);
    }
    Ok(f64::from(width as i32) / PIECES)
}

/// The given size, or a smaller one at which the text is not longer than `room`.
pub fn fitting(text: &str, size: f64, room: f64) -> Result<f64, PlotError> {
    let mut fitting = size;
    // widths are rounded to whole pixels, so the ratio alone may not be small enough
    while fitting > 1.0 && text_width(text, fitting)? > room {
        fitting *= (room / text_width(text, fitting)?).min(0.99);
    }
    Ok(fitting)
}

/// The text in lines that are not longer than `room`. A word that is too long for a line is divided.
pub fn wrapped(text: &str, size: f64, room: f64) -> Result<Vec<String>, PlotError> {
    let mut lines = vec![String::new()];
    for piece in text.split_inclusive(' ') {
        let line = lines.last().map_or("", String::as_str);
        if !line.is_empty() && text_width(format!("{line}{piece}").trim_end(), size)? > room {
            lines.push(String::new());
        }
        for letter in piece.chars() {
            let line = lines.last().map_or("", String::as_str);
            if !line.is_empty() && letter != ' ' && text_width(&format!("{line}{letter}"), size)? > room {
                lines.push(String::new());
            }
            if let Some(line) = lines.last_mut() {
                line.push(letter);
            }
        }
    }
    Ok(lines.into_iter().map(|line| line.trim_end().to_owned()).collect())
}
