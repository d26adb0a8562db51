//! The pictures of each kind of scenario: which results they show, as a [`Chart`](super::chart::Chart).

pub mod calibrate;
pub mod caption;
mod contact_trace;
mod contour;
mod force_indentation;
mod friction;
mod history;
mod indentation;
mod loops;
pub mod path;
mod posterior;
mod process_window;
mod pulse;
pub mod series;
pub mod sweep;
pub(crate) mod traces;

pub use caption::{caption, path_title, with_captions};
pub(crate) use caption::{key_axis, law_title, path_words};

pub use contact_trace::contact_trace;
pub use force_indentation::force_indentation;
pub use friction::friction;

pub use history::history;
pub use indentation::indentation;
pub use pulse::{pulse, spectrum};
