//! The registry of results: every number and word that the program reports, once. Summaries, the columns of tables and
//! traces, and the reference page come from here.
//!
//! An entry of a list gives, in this order: what the result means; its name, with the unit at its end and a dot behind the
//! name of a group in JSON; under which condition it is there (`if`); for a result of an impact that is a column of tables
//! too, what the column needs and how a row gives it (`[..]`); and its value. A value without a condition is always there,
//! as `null` (in CSV an empty field) where it is not finite or `None`.

pub mod compare;
mod entry;
pub mod impact;
pub mod indentation;
pub mod series;
pub mod table;

pub use entry::{Column, Described, Fields, File, Needs, Reported, fields};

/// The files, or parts of them, that hold results, in the order of the reference page.
pub fn files() -> Vec<File> {
    [impact::files(), series::files(), indentation::files(), compare::files(), table::files()].concat()
}

/// The columns of results that a table may have, in their order: those of elastic waves come last.
pub fn columns() -> Vec<Column> {
    let mut columns: Vec<Column> = impact::results().iter().filter_map(|result| result.column).collect();
    columns.sort_by_key(|column| column.needs == Needs::Density);
    columns
}
