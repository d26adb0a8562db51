//! Pictures of results as PNG or SVG, with the same bytes on every machine. They are drawn in memory with a built-in
//! font.
//!
//! Nothing here computes physics. The crate plotters draws lines, polygons and text. Axes, dashes and the key are laid
//! out here, because the charts of plotters have no dash pattern for each series, no key outside the axes, and no
//! engineering units on the ticks. Series differ by colour (the palette of Okabe and Ito, made for colour-blind
//! readers), by dash pattern and by marker.

pub mod axis;
pub mod calibrate;
mod canvas;
pub mod compare;
pub mod force_indentation;
mod frame;
pub mod heatmap;
pub mod histogram;
pub mod history;
pub mod indentation;
mod key;
pub mod lines;
mod mark;
mod of_key;
mod pictures;
mod posterior;
pub mod repeat;
mod sheet;
pub mod stack;
mod style;
pub mod sweep;

use thiserror::Error;

pub use axis::{Axis, Scale};
pub use canvas::Canvas;
pub use force_indentation::force_indentation;
pub use heatmap::Heatmap;
pub use histogram::Histogram;
pub use history::history;
pub use indentation::indentation;
pub use lines::{Guide, Lines, Look, Series};
pub use pictures::Pictures;
pub use stack::{Panel, Stack};
pub use style::Mark;

/// Size of every picture \[px\].
pub const SIZE: (u32, u32) = (1600, 1000);

/// Why a picture could not be made.
#[derive(Debug, Error)]
pub enum PlotError {
    #[error("the built-in font cannot be used")]
    Font,
    #[error("drawing: {0}")]
    Drawing(String),
    #[error("PNG: {0}")]
    Encoding(#[from] png::EncodingError),
    #[error("{0}")]
    Data(String),
}
