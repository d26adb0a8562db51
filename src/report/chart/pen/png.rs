//! Pictures as PNG: drawn at twice the size in the built-in font, then reduced for smooth edges.

use std::sync::LazyLock;

use plotters::prelude::BitMapBackend;
use plotters::style::{FontStyle, register_font};
use png::{BitDepth, ColorType, Encoder};

use super::{BackendFormat, Pen, drawing_error};
use crate::error::Error;
use crate::files::PROGRAM_NAME;
use crate::report::chart::style::{BACKGROUND, SIZE};

/// The pixels of a PNG are means of 2 × 2 drawn pixels.
const OVERSAMPLING: u32 = 2;
const PNG_FORMAT: BackendFormat = BackendFormat {
    units: OVERSAMPLING as f64,
    letters: 1.0,
    rise: 0.216,
    fonts: "sans-serif",
    overlap: 0.0,
    is_raster: true,
};

/// The picture as PNG: pixels, in the built-in font, with the same bytes on every machine.
pub fn render_png(paint: impl FnOnce(&mut Pen<BitMapBackend>) -> Result<(), Error>) -> Result<Vec<u8>, Error> {
    static IS_REGISTERED: LazyLock<bool> =
        LazyLock::new(|| register_font(PNG_FORMAT.fonts, FontStyle::Normal, dejavu::sans::regular()).is_ok());
    if !*IS_REGISTERED {
        return Err(Error::failed("the built-in font cannot be used"));
    }
    let size = (SIZE.0 * OVERSAMPLING, SIZE.1 * OVERSAMPLING);
    let mut buffer = vec![BACKGROUND.0; 3 * size.0 as usize * size.1 as usize];
    let sheet = (f64::from(SIZE.0), f64::from(SIZE.1));
    paint(&mut Pen { backend: &mut BitMapBackend::with_buffer(&mut buffer, size), format: PNG_FORMAT, sheet })?;
    encode_png(&buffer)
}

/// The PNG of a buffer that has [`OVERSAMPLING`] times as many pixels in each direction. The loop uses indices: in the build of the tests,
/// which is hardly optimised, iterators took nine tenths of the time of a picture.
fn encode_png(buffer: &[u8]) -> Result<Vec<u8>, Error> {
    const { assert!(OVERSAMPLING == 2) };
    let line = 3 * (OVERSAMPLING * SIZE.0) as usize;
    let mut pixels = Vec::with_capacity(3 * (SIZE.0 * SIZE.1) as usize);
    for lines in buffer.chunks_exact(2 * line) {
        let (upper, lower) = lines.split_at(line);
        // the rounded mean of one channel of four pixels; it fits a byte
        let mean = |at: usize| {
            let sum = u32::from(upper[at]) + u32::from(upper[at + 3]) + u32::from(lower[at]) + u32::from(lower[at + 3]);
            ((sum + 2) / 4).to_le_bytes()[0]
        };
        let mut left = 0;
        while left < line {
            pixels.extend_from_slice(&[mean(left), mean(left + 1), mean(left + 2)]);
            left += 6;
        }
    }
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, SIZE.0, SIZE.1);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    // the name of the program tells a picture of the program from another one of the same size
    encoder.add_text_chunk("Software".to_owned(), PROGRAM_NAME.to_owned()).map_err(drawing_error)?;
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&pixels)?;
        writer.finish()
    });
    written.map(|()| file).map_err(drawing_error)
}
