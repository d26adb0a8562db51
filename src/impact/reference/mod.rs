//! Reference data that checks, comparisons and pictures show beside the laws: finite-element results of this project for the
//! five material cases of Xie et al. (2024), for half-spaces that harden and for whole impacts; 30-digit impacts; measured
//! rebound hardness and oblique rebounds. The head of each table in `src/impact/reference` says
//! where it comes from, how it was obtained and its error.

/// Rows of tables that are compiled in: their fields, each with the name of its column where that is another one, and the
/// function that reads the table of such rows, if there is one.
macro_rules! rows {
    ($($(#[$about:meta])* pub struct $row:ident $(read by $read:ident from $file:literal)? {
        $($(#[$of_field:meta])* $vis:vis $field:ident $(as $column:literal)?: $type:ty,)+
    })+) => {$(
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq, serde::Deserialize)]
        pub struct $row {
            $($(#[$of_field])* $(#[serde(rename = $column)])? $vis $field: $type,)+
        }

        $(
            pub fn $read() -> Result<Vec<$row>, $crate::error::Error> {
                $crate::impact::reference::rows($file, include_str!($file))
            }
        )?
    )+};
}
pub mod hardening;
pub mod impacts;
pub mod loading;
pub mod measured;
pub mod quasi_static;
pub mod unloading;
pub mod yielding;

use serde::de::DeserializeOwned;

use crate::error::Error;

/// Name of the quasi-static finite elements in reports.
pub const STATIC: &str = "finite elements, CalculiX 2.20, src/impact/reference/fe_*.csv";
/// Name of the finite elements of whole impacts in reports.
pub const DYNAMIC: &str = "explicit finite elements, src/impact/reference/fe_dynamic.csv";

/// The error of a damaged table; the tables are compiled in.
pub(crate) fn damaged(table: &str, problem: &str) -> Error {
    Error::failed(format!("reference table {table}: {problem}"))
}

fn rows<T: DeserializeOwned>(table: &'static str, text: &str) -> Result<Vec<T>, Error> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let rows = reader.deserialize().collect::<Result<Vec<T>, csv::Error>>();
    rows.map_err(|error| damaged(table, &error.to_string()))
}
