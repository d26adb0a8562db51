//! Colours, dash patterns and markers. Each series differs from the one before in all three.

use plotters::style::RGBColor;

pub(super) const INK: RGBColor = RGBColor(0x22, 0x22, 0x22);
pub(super) const GREY: RGBColor = RGBColor(0x77, 0x77, 0x77);
pub(super) const GRID: RGBColor = RGBColor(0xe2, 0xe2, 0xe2);
pub(super) const PAPER: RGBColor = RGBColor(0xff, 0xff, 0xff);
/// Blue, vermillion, bluish green, reddish purple, orange, sky blue, black: Okabe and Ito (2008), without the yellow,
/// which is too pale for a line on white.
pub(super) const PALETTE: [RGBColor; 7] = [
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xcc, 0x79, 0xa7),
    RGBColor(0xe6, 0x9f, 0x00),
    RGBColor(0x56, 0xb4, 0xe9),
    RGBColor(0x00, 0x00, 0x00),
];

/// A mixture of this share of a colour with the colour of the paper.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between two colours
pub(super) fn tinted(color: RGBColor, share: f64) -> RGBColor {
    let mixed = |paper: u8, ink: u8| (f64::from(paper) + share * (f64::from(ink) - f64::from(paper))).round() as u8;
    RGBColor(mixed(PAPER.0, color.0), mixed(PAPER.1, color.1), mixed(PAPER.2, color.2))
}

/// Text sizes \[px\].
pub(super) const TITLE_SIZE: f64 = 38.0;
pub(super) const AXIS_SIZE: f64 = 32.0;
pub(super) const LABEL_SIZE: f64 = 28.0;

/// Lengths of dashes and gaps, alternating \[px\]; empty for a solid line.
pub(super) type Dash = &'static [f64];
pub(super) const SOLID: Dash = &[];
pub(super) const DASHED: Dash = &[16.0, 10.0];
pub(super) const DOTTED: Dash = &[3.0, 8.0];
const DASHES: [Dash; 5] = [SOLID, DASHED, &[16.0, 8.0, 3.0, 8.0], &[7.0, 6.0], &[16.0, 7.0, 3.0, 7.0, 3.0, 7.0]];

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    pub color: RGBColor,
    pub width: f64,
    pub dash: Dash,
}

impl Stroke {
    pub(super) fn solid(color: RGBColor, width: f64) -> Self {
        Self { color, width, dash: SOLID }
    }
}

/// The shape that marks points of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// ●
    Circle,
    /// ■
    Square,
    /// ▲
    Triangle,
    /// ◆
    Diamond,
    /// ▼
    Inverted,
    /// ✕
    Cross,
    /// +
    Plus,
}

const MARKS: [Mark; 7] =
    [Mark::Circle, Mark::Square, Mark::Triangle, Mark::Diamond, Mark::Inverted, Mark::Cross, Mark::Plus];

/// Index of the style of finite elements and of measurements beside curves of laws: a black circle.
pub(super) const BLACK: usize = 13;
/// Index of the style of a fitted law: a solid line in the second colour.
pub(super) const LAW: usize = 15;

/// How a point is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Marker {
    pub shape: Mark,
    /// \[px\].
    pub radius: f64,
    pub color: RGBColor,
}

/// Colour, dash and marker of a series. There are 7 colours and 5 dashes, so their combination repeats only after 35
/// series. The markers move by one after each round of colours.
pub(super) fn series(index: usize) -> (Stroke, Mark) {
    let color = PALETTE[index % PALETTE.len()];
    let dash = DASHES[index % DASHES.len()];
    let mark = MARKS[(index + index / PALETTE.len()) % MARKS.len()];
    (Stroke { color, width: 3.0, dash }, mark)
}

/// A series as a solid line of this width \[px\], with markers of this radius \[px\].
pub(super) fn solid(index: usize, width: f64, radius: f64) -> (Stroke, Marker) {
    let (Stroke { color, .. }, shape) = series(index);
    (Stroke::solid(color, width), Marker { shape, radius, color })
}
