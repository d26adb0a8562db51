//! The looks of lines and points: colours, dash patterns and markers. Each series differs from the one before in all three.

use plotters::style::RGBColor;

/// Size of every picture \[px\].
pub const SIZE: (u32, u32) = (1600, 1000);

pub const FOREGROUND: RGBColor = RGBColor(0x22, 0x22, 0x22);
pub const GREY: RGBColor = RGBColor(0x77, 0x77, 0x77);
pub const GRID: RGBColor = RGBColor(0xe2, 0xe2, 0xe2);
pub const BACKGROUND: RGBColor = RGBColor(0xff, 0xff, 0xff);
/// Blue, vermillion, bluish green, reddish purple, orange, sky blue, black: Okabe and Ito (2008), without the yellow,
/// which is too pale for a line on white. Then wine, olive, brown, indigo, dark green and rose, of which the first, the second
/// and the last three are of the muted colours of Tol (2021): a picture of all laws has twelve lines.
pub const PALETTE: [RGBColor; 13] = [
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xcc, 0x79, 0xa7),
    RGBColor(0xe6, 0x9f, 0x00),
    RGBColor(0x56, 0xb4, 0xe9),
    RGBColor(0x00, 0x00, 0x00),
    RGBColor(0x88, 0x22, 0x55),
    RGBColor(0x99, 0x99, 0x33),
    RGBColor(0x8c, 0x56, 0x2b),
    RGBColor(0x33, 0x22, 0x88),
    RGBColor(0x11, 0x77, 0x33),
    RGBColor(0xcc, 0x66, 0x77),
];

/// Text sizes \[px\].
pub const TITLE_SIZE: f64 = 38.0;
pub const AXIS_SIZE: f64 = 32.0;
pub const LABEL_SIZE: f64 = 28.0;
/// Radius of markers \[px\].
pub const MARKER_RADIUS: f64 = 9.0;

/// Lengths of dashes and gaps, alternating \[px\]; empty for a solid line.
pub type Dash = &'static [f64];
pub const SOLID: Dash = &[];
pub const DASHED: Dash = &[16.0, 10.0];
pub const DOTTED: Dash = &[3.0, 8.0];
const DASHES: [Dash; 5] = [SOLID, DASHED, &[16.0, 8.0, 3.0, 8.0], &[7.0, 6.0], &[16.0, 7.0, 3.0, 7.0, 3.0, 7.0]];

/// The shape that marks points of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// ●
    Circle,
    /// ■
    Square,
    /// ▲
    Triangle,
    /// ◆
    Diamond,
    /// ▼
    TriangleDown,
    /// ✕
    Cross,
    /// +
    Plus,
}

const MARKERS: [Marker; 7] = [
    Marker::Circle,
    Marker::Square,
    Marker::Triangle,
    Marker::Diamond,
    Marker::TriangleDown,
    Marker::Cross,
    Marker::Plus,
];

/// How a line and its points are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    pub(in crate::report) color: RGBColor,
    /// Width of the line \[px\].
    pub(in crate::report) width: f64,
    pub(in crate::report) dash: Dash,
    pub(in crate::report) mark: Marker,
    /// Radius of the markers \[px\].
    pub(in crate::report) radius: f64,
}

impl Style {
    /// Finite elements and measurements beside curves of laws: black circles.
    pub const BLACK: Self =
        Self { color: PALETTE[6], width: 3.0, dash: SOLID, mark: Marker::Circle, radius: MARKER_RADIUS };
    /// Finite elements beside measurements: grey circles.
    pub const GREY: Self = Self { color: GREY, ..Self::BLACK };
    /// A fitted law: a solid line in vermillion.
    pub const LAW: Self = Self { color: PALETTE[1], ..Self::BLACK };

    /// The style of the series with this number. There are 13 colours and 5 dashes, so their combination repeats only
    /// after 65 series. The markers move by one after each round of colours.
    pub fn new(number: usize) -> Self {
        Self {
            color: PALETTE[number % PALETTE.len()],
            dash: DASHES[number % DASHES.len()],
            mark: MARKERS[(number + number / PALETTE.len()) % MARKERS.len()],
            ..Self::BLACK
        }
    }

    /// Returns the style with the marker of this number.
    pub fn with_marker_of(self, number: usize) -> Self {
        Self { mark: MARKERS[number % MARKERS.len()], ..self }
    }

    /// Returns the style with a solid line.
    pub fn with_solid_line(self) -> Self {
        self.with_dash(SOLID)
    }

    /// Returns the style with a solid line for 0 and a dashed one for 1.
    pub fn with_line_of_branch(self, which: usize) -> Self {
        self.with_dash(if which == 0 { SOLID } else { DASHED })
    }

    pub(in crate::report) fn with_dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    pub(in crate::report) fn line(color: RGBColor, width: f64) -> Self {
        Self { color, width, ..Self::BLACK }
    }

    pub(in crate::report) fn marker(mark: Marker, color: RGBColor) -> Self {
        Self { color, mark, ..Self::BLACK }
    }
    pub fn with_width(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// The pale colour of a band: its colour mixed with that of the paper.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between two colours
    pub(in crate::report) fn light_color(self) -> RGBColor {
        let mixed = |paper: u8, ink: u8| (f64::from(paper) + 0.35 * (f64::from(ink) - f64::from(paper))).round() as u8;
        let RGBColor(red, green, blue) = self.color;
        RGBColor(mixed(BACKGROUND.0, red), mixed(BACKGROUND.1, green), mixed(BACKGROUND.2, blue))
    }
}

impl From<usize> for Style {
    fn from(number: usize) -> Self {
        Self::new(number)
    }
}
