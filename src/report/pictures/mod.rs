//! Pictures of results as PNG or SVG, with the same bytes on every machine. They are drawn in memory with a built-in
//! font.
//!
//! Nothing here computes physics. Every picture is data, a [`Chart`](super::chart::Chart), and the crate plotters draws its lines, areas and
//! texts. Axes, clipping and the key are laid out here, because the charts of plotters do not serve: they move points
//! outside the axes to the edge, which bends the lines (plotters issues 429 and 622), they have no key outside the
//! axes, and no dash patterns of two lengths. Series differ by colour (the palette of Okabe and Ito, made for
//! colour-blind readers), by dash pattern and by marker.

pub mod calibrate;
pub mod caption;
mod force_indentation;
mod friction;
mod history;
mod indentation;
mod loops;
mod posterior;
pub mod series;
pub mod sweep;

pub use caption::{caption, path_title, with_captions};
pub(crate) use caption::{key_axis, law_title, path_words};

pub use force_indentation::force_indentation;
pub use friction::friction;

pub use history::history;
pub use indentation::indentation;
