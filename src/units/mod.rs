//! Quantities as people write them, such as "5 mm", "210GPa", "7.85 g/cm^3": to SI and back.
//!
//! Beside quantities it has other text that people read and write: aligned tables, CSV, and names of options with "did you mean".
//!
//! This module knows neither scenarios nor mechanics. One table holds every unit. Where a unit is a power of ten of the SI
//! unit, its exponent is added to that of the decimal text, which is then rounded to binary once: "5 mm" is the same number
//! as 0.005.

mod aligned;
pub(crate) mod csv_text;
mod dimension;
mod format;
#[doc(hidden)]
pub mod names;
mod parse;
pub(crate) mod rounded;
mod table;

pub use aligned::{aligned, markdown};
pub use dimension::Dimension;
pub use format::{capital, describe, exact, four_digits, human, number, percent, quantities, quantity, si};
pub(crate) use names::named;
pub use names::{did_you_mean, known_names};
pub use parse::{parse, parse_as};
