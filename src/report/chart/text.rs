//! Widths of texts, with the same bits for every format and on every machine, and what follows from them: sizes and lines.

/// Widths are whole numbers of these pieces of a pixel, as plotters measures the letters of a PNG.
const PIECES_PER_PIXEL: f64 = 2.0;

/// Units of the font from the lowest to the highest letter: this is the size of a text.
const FONT_HEIGHT: f64 = 2384.0;

/// Widths in units of the font of the pictures, DejaVu Sans: a first character, and those that follow it.
const WIDTHS: &[(char, &[u16])] = &[
    (
        ' ',
        &[
            651, 821, 942, 1716, 1303, 1946, 1597, 563, 799, 799, 1024, 1716, 651, 739, 651, 690, 1303, 1303, 1303,
            1303, 1303, 1303, 1303, 1303, 1303, 1303, 690, 690, 1716, 1716, 1716, 1087, 2048, 1401, 1405, 1430, 1577,
            1294, 1178, 1587, 1540, 604, 604, 1343, 1141, 1767, 1532, 1612, 1235, 1612, 1423, 1300, 1251, 1499, 1401,
            2025, 1403, 1251, 1403, 799, 690, 799, 1716, 1024, 1024, 1255, 1300, 1126, 1300, 1260, 721, 1300, 1298,
            569, 569, 1186, 569, 1995, 1298, 1253, 1300, 1300, 842, 1067, 803, 1298, 1212, 1675, 1212, 1212, 1075,
            1303, 690, 1303, 1716,
        ],
    ),
    (
        '\u{a0}',
        &[
            651, 821, 1303, 1303, 1303, 1303, 690, 1024, 1024, 2048, 965, 1253, 1716, 739, 2048, 1024, 1024, 1716, 821,
            821, 1024, 1303, 1303, 651, 1024, 821, 965, 1253, 1985, 1985, 1985, 1087, 1401, 1401, 1401, 1401, 1401,
            1401, 1995, 1430, 1294, 1294, 1294, 1294, 604, 604, 604, 604, 1587, 1532, 1612, 1612, 1612, 1612, 1612,
            1716, 1612, 1499, 1499, 1499, 1499, 1251, 1239, 1290, 1255, 1255, 1255, 1255, 1255, 1255, 2011, 1126, 1260,
            1260, 1260, 1260, 569, 569, 569, 569, 1253, 1298, 1253, 1253, 1253, 1253, 1253, 1716, 1253, 1298, 1298,
            1298, 1298, 1212, 1300, 1212,
        ],
    ),
    (
        'α',
        &[
            1350, 1307, 1212, 1253, 1107, 1114, 1298, 1253, 693, 1207, 1212, 1303, 1144, 1142, 1253, 1233, 1300, 1202,
            1298, 1233, 1185, 1351, 1183, 1351, 1715,
        ],
    ),
    ('–', &[1024]),
    ('…', &[2048]),
    ('′', &[465]),
    ('⁰', &[821]),
    ('⁴', &[821, 821, 821, 821, 821, 821, 1081, 1081]),
    ('ᵣ', &[530]),
    ('ₕ', &[828]),
    ('ₘ', &[1276]),
    ('ₛ', &[764]),
    ('−', &[1716]),
    ('√', &[1305]),
];

/// The width of any other character.
const DEFAULT_WIDTH: u16 = 1400;

fn width_of(letter: char) -> u16 {
    let of_run = |(first, widths): &(char, &[u16])| {
        let place = u32::from(letter).checked_sub(u32::from(*first))?;
        widths.get(place as usize).copied()
    };
    WIDTHS.iter().find_map(of_run).unwrap_or(DEFAULT_WIDTH)
}

/// Width of a text in the font of the pictures \[px\]: the sum of the widths of its letters, without kerning.
pub fn text_width(text: &str, size: f64) -> f64 {
    let units: u32 = text.chars().map(|letter| u32::from(width_of(letter))).sum();
    (PIECES_PER_PIXEL * size * f64::from(units) / FONT_HEIGHT).floor() / PIECES_PER_PIXEL
}

/// The given size, or a smaller one at which the text is not longer than `room`.
pub fn fitting_size(text: &str, size: f64, room: f64) -> f64 {
    let mut fitting = size;
    // widths are rounded to whole pixels, so the ratio alone may not be small enough
    while fitting > 1.0 && text_width(text, fitting) > room {
        fitting *= (room / text_width(text, fitting)).min(0.99);
    }
    fitting
}

/// The text in lines that are not longer than `room`. A word that is too long for a line is divided.
pub fn wrap(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for piece in text.split_inclusive(' ') {
        let line = lines.last().map_or("", String::as_str);
        if !line.is_empty() && text_width(format!("{line}{piece}").trim_end(), size) > room {
            lines.push(String::new());
        }
        for letter in piece.chars() {
            let line = lines.last().map_or("", String::as_str);
            if !line.is_empty() && letter != ' ' && text_width(&format!("{line}{letter}"), size) > room {
                lines.push(String::new());
            }
            if let Some(line) = lines.last_mut() {
                line.push(letter);
            }
        }
    }
    lines.into_iter().map(|line| line.trim_end().to_owned()).collect()
}

/// The text with a minus sign in place of a hyphen before a negative number: "-2.6" and "1e-5", but not "half-space" or
/// "aluminium-6061".
pub fn with_minus(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let is_digit = |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(char::is_ascii_digit);
    let is_minus = |at: usize| {
        let before = at.checked_sub(1).and_then(|at| letters.get(at));
        let is_sign = before.is_none_or(|before| " =(+±,;".contains(*before));
        let is_exponent = before == Some(&'e') && is_digit(at.checked_sub(2));
        letters[at] == '-' && is_digit(Some(at + 1)) && (is_sign || is_exponent)
    };
    (0..letters.len()).map(|at| if is_minus(at) { '−' } else { letters[at] }).collect()
}

#[cfg(test)]
mod tests {
    use ab_glyph::{Font as _, FontRef};

    use super::*;

    #[test]
    fn only_numbers_have_a_minus_sign() {
        for (text, written) in [
            ("e = -2.623", "e = −2.623"),
            ("-5 mm", "−5 mm"),
            ("1.2e-5 m", "1.2e−5 m"),
            ("half-space of aluminium-6061-t6", "half-space of aluminium-6061-t6"),
            ("bronze-90, 2024-11-25", "bronze-90, 2024-11-25"),
        ] {
            assert_eq!(with_minus(text), written);
        }
    }

    #[test]
    fn the_widths_are_those_of_the_font() {
        let font = FontRef::try_from_slice(dejavu::sans::regular()).unwrap();
        assert_eq!(f64::from(font.height_unscaled()), FONT_HEIGHT);
        for (first, widths) in WIDTHS {
            for (letter, width) in (*first..).zip(*widths) {
                let of_font = font.h_advance_unscaled(font.glyph_id(letter));
                assert_eq!(of_font, f32::from(*width), "{letter}");
            }
        }
    }
}
