//! Makes the font by which the pictures measure their texts: DejaVu Sans without the shapes of its letters, a sixteenth of
//! its size. Only a PNG needs the shapes.

use std::error::Error;
use std::path::Path;

/// What a width follows from: the size of the font, the letter of a character, its advance, and kerning.
const KEPT: [&[u8]; 6] = [b"cmap", b"head", b"hhea", b"hmtx", b"kern", b"maxp"];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=src/plot/text/build.rs");
    let font = widths_of(dejavu::sans::regular()).ok_or("the font has another form")?;
    Ok(std::fs::write(Path::new(&std::env::var("OUT_DIR")?).join("widths.ttf"), font)?)
}

/// A font with the tables of [`KEPT`] alone: a head of 12 bytes, 16 bytes for each table (name, checksum, offset, length), and
/// the tables.
fn widths_of(font: &[u8]) -> Option<Vec<u8>> {
    let number = |at: usize| usize::try_from(u32::from_be_bytes(font.get(at..at + 4)?.try_into().ok()?)).ok();
    let entries = font.get(12..)?.chunks_exact(16).enumerate().take(usize::from(font[5]));
    let kept: Vec<(usize, &[u8])> = entries.filter(|(_, entry)| KEPT.contains(&&entry[..4])).collect();
    let mut directory = [&font[..4], &[0, u8::try_from(kept.len()).ok()?], &[0; 6]].concat();
    let mut tables = Vec::new();
    for (place, entry) in &kept {
        let start = number(12 + 16 * place + 8)?;
        let offset = u32::try_from(12 + 16 * kept.len() + tables.len()).ok()?;
        directory.extend([&entry[..8], &offset.to_be_bytes(), &entry[12..]].concat());
        tables.extend_from_slice(font.get(start..start + number(12 + 16 * place + 12)?)?);
        tables.resize(tables.len().next_multiple_of(4), 0);
    }
    (kept.len() == KEPT.len()).then(|| [directory, tables].concat())
}
