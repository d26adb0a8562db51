//! Texts about a run: files, and tables for the terminal. Nothing here opens a file or prints.

pub(crate) mod calibrate;
pub(crate) mod checked;
pub(crate) mod files;
pub(crate) mod indentation;
pub mod inputs;
pub mod laws;
pub mod materials;
pub(crate) mod overview;
pub(crate) mod plan;
pub mod reference;
pub(crate) mod repeat;
pub(crate) mod series;
pub mod sweep;
mod terminal;

pub use files::trace;
pub use terminal::{Detail, impact as table};

use crate::scenario::scene::results::{FileOfResults, impact};

/// The files of results of every kind of scene.
fn results() -> Vec<FileOfResults> {
    let of_kinds = [impact::files, series::files, indentation::files, sweep::files, calibrate::files, checked::files];
    of_kinds.into_iter().flat_map(|files| files()).collect()
}
