//! Quantities as people write them, such as "5 mm", "210GPa", "7.85 g/cm^3": to SI and back.
//!
//! This module does not depend on scenarios or mechanics. One table holds every unit. Where a unit is a power of ten of the SI
//! unit, its exponent is added to that of the decimal text, which is then rounded to binary once: "5 mm" is the same number
//! as 0.005.

mod dimension;
mod format;
mod parse;
pub(crate) mod prefix;
mod table;

pub use dimension::Dimension;
pub use format::{
    format_exact, format_four_digits, format_input, format_number, format_percent, format_result, format_si,
    format_si_and_short, quantities,
};

pub use parse::{parse, parse_named};
