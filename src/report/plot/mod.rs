//! Pictures of results as PNG or SVG, with the same bytes on every machine. They are drawn in memory with a built-in
//! font.
//!
//! Nothing here computes physics. Every picture is data, a [`Chart`], and the crate plotters draws its lines, areas and
//! texts. Axes, clipping and the key are laid out here, because the charts of plotters do not serve: they move points
//! outside the axes to the edge, which bends the lines (plotters issues 429 and 622), they have no key outside the
//! axes, and no dash patterns of two lengths. Series differ by colour (the palette of Okabe and Ito, made for
//! colour-blind readers), by dash pattern and by marker.

pub mod axis;
pub mod calibrate;
pub mod caption;
mod chart;
mod force_indentation;
mod frame;
mod friction;
mod heatmap;
mod histogram;
mod history;
mod indentation;
mod key;
mod loops;
mod pen;
mod pictures;
mod posterior;
pub mod repeat;
mod series;
mod style;
pub mod sweep;
mod text;

pub use axis::{Axis, Scale, extremes};
pub(crate) use caption::{axis_of, law_title, words_of};
pub use caption::{caption, captioned, title_of};
pub(crate) use chart::Cell;
pub use chart::{Chart, Panel};
pub use force_indentation::force_indentation;
pub use friction::friction;
pub use heatmap::heatmap;
pub use histogram::histogram;
pub use history::history;
pub use indentation::indentation;
pub use pictures::Pictures;
pub use series::{Look, Series};
pub(crate) use style::{DASHED, DOTTED, GREY, GRID, INK, MARK, PALETTE, PAPER, SOLID};
pub use style::{Mark, Style};

/// Size of every picture \[px\].
pub const SIZE: (u32, u32) = (1600, 1000);
