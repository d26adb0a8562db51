//! Reference data that checks, comparisons and pictures show beside the laws: finite-element results of this project for the
//! five material cases of Xie et al. (2024), for half-spaces that harden and for whole impacts; measured rebound hardness,
//! bounces and oblique rebounds. The head of each table in `src/reference` says where it comes from, how it was
//! obtained and its error, and explains its columns, whose names have their unit.

pub mod hardening;
pub mod loading;
pub mod measured;
pub mod quasi_static;

use std::collections::BTreeMap;

use crate::error::Error;

/// Name of the quasi-static finite elements in reports.
pub const QUASI_STATIC_SOURCE: &str = "finite elements, CalculiX 2.20, src/reference/fe_*.csv";
/// Name of the finite elements of whole impacts in reports.
pub const DYNAMIC_SOURCE: &str = "explicit finite elements, src/reference/fe_dynamic.csv";

/// A table that is compiled in: its name and its text.
#[derive(Debug, Clone, Copy)]
pub struct ReferenceTable(&'static str, &'static str);

macro_rules! table {
    ($file:literal) => {
        ReferenceTable($file, include_str!($file))
    };
}

/// Whole impacts by explicit finite elements, and their curves.
pub const IMPACTS: ReferenceTable = table!("fe_dynamic.csv");
pub const CURVES_OF_IMPACTS: ReferenceTable = table!("fe_dynamic_curves.csv");
/// Whole impacts on half-spaces whose strength rises with the strain rate.
pub const RATE_IMPACTS: ReferenceTable = table!("fe_rate.csv");
/// Full unloadings on half-spaces that do not harden, their curves, and full unloadings on those that harden.
pub const UNLOADINGS: ReferenceTable = table!("fe_unloading.csv");
pub const CURVES_OF_UNLOADINGS: ReferenceTable = table!("fe_unloading_curves.csv");
pub const HARDENING: ReferenceTable = table!("fe_hardening.csv");
/// Full unloadings of deep dents, and of half-spaces with another Poisson's ratio than 0.3.
pub const DEEP_UNLOADINGS: ReferenceTable = table!("fe_deep.csv");
pub const POISSONS_RATIOS: ReferenceTable = table!("fe_poisson.csv");
/// Whole impacts of shots that leave deep dents.
pub const DEEP_IMPACTS: ReferenceTable = table!("fe_deep_impacts.csv");
/// Plastic zones and residual stresses below dents.
pub const RESIDUAL_STRESSES: ReferenceTable = table!("fe_residual.csv");
/// Load cycles in which the sphere yields, alone or with the half-space.
pub const YIELDING: ReferenceTable = table!("fe_yielding.csv");
/// Impact devices after Leeb with what they show on two test blocks, and the ranges of hardness and strength of steels.
pub const LEEB_DEVICES: ReferenceTable = table!("leeb.csv");
pub const LEEB_STEELS: ReferenceTable = table!("leeb_tensile.csv");
/// Times between the bounces of a table-tennis ball; the height stands in the first line of a drop.
pub const BOUNCE_INTERVALS: ReferenceTable = table!("../../scenarios/clicks.csv");
/// Oblique rebounds: measured, and by finite elements.
pub const REBOUNDS: ReferenceTable = table!("kharaz.csv");
pub const OBLIQUE_SLIPS: ReferenceTable = table!("fe_oblique.csv");

/// A row of a table: its cells by the names of their columns.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceRow(BTreeMap<String, String>);

impl ReferenceTable {
    /// Its rows.
    ///
    /// # Errors
    /// [`Error`] if the table is damaged.
    pub fn rows(&self) -> Result<Vec<ReferenceRow>, Error> {
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(self.1.as_bytes());
        let rows = reader.deserialize().map(|row| row.map(ReferenceRow)).collect::<Result<_, csv::Error>>();
        rows.map_err(|error| damaged_table(self.0, &error.to_string()))
    }
}

impl ReferenceRow {
    /// The text of a cell; empty if the cell does not exist.
    pub fn cell_text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", String::as_str)
    }

    /// The number in a cell; `None` where it is empty.
    pub fn optional_number(&self, column: &str) -> Option<f64> {
        self.cell_text(column).parse().ok()
    }

    /// The number in a cell; NaN if the cell holds no number.
    pub fn number(&self, column: &str) -> f64 {
        self.optional_number(column).unwrap_or(f64::NAN)
    }

    /// The keys of a scenario that the row gives: the columns whose names have a dot.
    pub fn keys(&self) -> Vec<String> {
        let is_key = |(name, cell): &(&String, &String)| name.contains('.') && !cell.is_empty();
        self.0.iter().filter(is_key).map(|(name, cell)| format!("{name}={cell}")).collect()
    }
}

/// The error of a damaged table; the tables are compiled in.
pub(crate) fn damaged_table(table: &str, problem: &str) -> Error {
    Error::failed(format!("reference table {table}: {problem}"))
}
