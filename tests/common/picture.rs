//! Checks of decoded pictures.

/// Width of the border of a picture that must be white \[px\]. A text that is cut off would reach into it.
const BORDER: usize = 3;

/// The width of a PNG, and the colours of its pixels, row after row.
pub fn pixels(bytes: &[u8]) -> (usize, Vec<[u8; 3]>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), plm_impact::report::chart::SIZE);
    assert_eq!(info.color_type, png::ColorType::Rgb);
    (info.width as usize, pixels.chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect())
}

/// True if the border of a PNG is white, and its middle is not.
pub fn has_free_border(bytes: &[u8]) -> bool {
    let (width, pixels) = pixels(bytes);
    has_white_border(width, &pixels) && pixels.iter().any(|pixel| *pixel != [255; 3])
}

pub fn has_white_border(width: usize, pixels: &[[u8; 3]]) -> bool {
    let height = pixels.len() / width;
    let is_border = |i: usize| {
        let (x, y) = (i % width, i / width);
        x < BORDER || y < BORDER || x >= width - BORDER || y >= height - BORDER
    };
    pixels.iter().enumerate().filter(|(i, _)| is_border(*i)).all(|(_, pixel)| *pixel == [255; 3])
}
