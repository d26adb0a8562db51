//! Text that people read and write: aligned tables, CSV as spreadsheets write it, named enums, "did you mean".

pub(crate) mod aligned;
pub(crate) mod csv;
#[doc(hidden)]
pub mod names;

pub use aligned::{align_columns, markdown_table};
pub(crate) use names::named_enum;
pub use names::{did_you_mean, known_names};

/// The text with a capital letter at its beginning.
pub fn capitalise(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
