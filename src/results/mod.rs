//! The registry of results: every number and word that the program reports, once. Summaries, the columns of tables and
//! traces, the terminal and the reference page come from it. Here are the results of one impact, which tables have as
//! columns, and of a series. The results of the other kinds of scenario stand beside their texts, in `report`.
//!
//! An entry of a list has these parts, in this order:
//!
//! * what the result means, in one sentence;
//! * its name. The name ends in the unit; in JSON, the part before a dot is the name of a group;
//! * `in` and its dimension, or how its number is shown: [`NumberFormat`];
//! * `as` and a label, for a result that the terminal shows; `briefly` and a label, for one that a brief answer shows too;
//! * `if` and a condition, for a result that is not always there. A result without a condition is always there: as `null` (in
//!   CSV as an empty field) where its value is not finite or `None`;
//! * its value; for a result of an impact that is also a column of tables: in brackets what it needs, and how a row gives it.

pub mod dent_interval;
pub(crate) mod entry;
pub mod hardness_scales;
pub mod impact;
pub mod pulse;
pub mod restitution_interval;
pub mod series;
pub mod trace;

pub(crate) use entry::result_specs;
pub use entry::{NumberFormat, Requirement, ResultColumn, ResultSpec, TABLES, to_field_list, to_fields};

use crate::units::Dimension;

/// The result that most people ask for; a table always has it.
pub const RESTITUTION: &str = "restitution";

/// The columns that exist only if a scenario names them, or has `[peening]`.
pub const SUBSURFACE_COLUMNS: [&str; 6] = [
    "plastic_zone_depth_m",
    "plastic_zone_depth_sd_m",
    "compressive_layer_depth_m",
    "compressive_layer_depth_sd_m",
    "residual_compression_Pa",
    "residual_compression_sd_Pa",
];

/// The columns whose means give the coverage by random shots: area of a dent, and mass of a shot.
pub const PEENING_MEANS: [&str; 2] = ["dent_area_m2", "shot_mass_kg"];

/// The columns of results that a table may have, in their order: those of plates, rods and elastic waves come last.
pub fn result_columns() -> Vec<ResultColumn> {
    let mut columns: Vec<ResultColumn> = impact::impact_results().iter().filter_map(|result| result.column).collect();
    columns.sort_by_key(|column| match column.needs {
        Requirement::Thickness | Requirement::Rod | Requirement::Waveguide => 1,
        Requirement::Density => 2,
        _ => 0,
    });
    columns
}

/// The dimension of a result of an impact; a plain number where its name has no unit.
pub fn dimension_of(name: &str) -> Dimension {
    match impact::impact_results().iter().find(|result| result.name == name).map(|result| result.format) {
        Some(NumberFormat::Unit(dimension)) => dimension,
        _ => Dimension::Ratio,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn list_of_subsurface_columns_is_complete() {
        let columns = result_columns();
        let needing: Vec<&str> =
            columns.iter().filter(|column| column.needs == Requirement::Subsurface).map(|column| column.name).collect();
        assert_eq!(needing, SUBSURFACE_COLUMNS);
    }
}
