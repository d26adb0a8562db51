//! Checks of decoded pictures.

/// Width of the border of a picture that must be white \[px\]. A text that is cut off would reach into it.
const BORDER: usize = 3;

/// Whether the border of a PNG is white.
pub fn has_free_border(bytes: &[u8]) -> bool {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), plm_impact::plot::SIZE);
    let (width, height) = (info.width as usize, info.height as usize);
    let is_border = |i: usize| {
        let (x, y) = (i % width, i / width);
        x < BORDER || y < BORDER || x >= width - BORDER || y >= height - BORDER
    };
    pixels.chunks_exact(3).enumerate().filter(|(i, _)| is_border(*i)).all(|(_, pixel)| pixel == [255; 3])
}
