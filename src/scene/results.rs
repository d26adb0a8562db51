//! The registry of results: every number and word that the program reports, once. Summaries, the columns of tables and
//! traces, the terminal and the reference page come from here.
//!
//! An entry of a list has these parts, in this order:
//!
//! * what the result means, in one sentence;
//! * its name. The name ends in the unit; in JSON, the part before a dot is the name of a group;
//! * `in` and its dimension, or how its number is shown: [`Shown`];
//! * `as` and a label, for a result that the terminal shows;
//! * `if` and a condition, for a result that is not always there. A result without a condition is always there: as `null` (in
//!   CSV as an empty field) where its value is not finite or `None`;
//! * its value; for a result of an impact that is also a column of tables: in brackets what it needs, and how a row gives it.

pub mod compare;
pub(crate) mod entry;
pub mod impact;
pub mod indentation;
pub mod series;
pub mod table;

pub use entry::{Column, Fields, Needs, Reported, Shown, fields};

/// The results of all runs but calibrations as Markdown, a table for every file, or part of one, that has them.
pub fn files() -> String {
    [impact::files(), series::files(), indentation::files(), compare::files(), table::files()].concat()
}

/// The columns of results that a table may have, in their order: those of plates and of elastic waves come last.
pub fn columns() -> Vec<Column> {
    let mut columns: Vec<Column> = impact::results().iter().filter_map(|result| result.column).collect();
    columns.sort_by_key(|column| (column.needs == Needs::Density, column.needs == Needs::Thickness));
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names<T>(results: &[Reported<T>]) -> Vec<(&'static str, Shown)> {
        results.iter().map(|result| (result.name, result.shown)).collect()
    }

    #[test]
    fn a_name_ends_in_the_unit_of_its_number_and_no_other_name_does() {
        let all = [
            names(&impact::results()),
            names(&impact::trace()),
            names(&series::results()),
            names(&series::impacts()),
            names(&series::trace()),
            names(&indentation::half_space()),
            names(&indentation::step()),
            names(&indentation::trace()),
            names(&compare::row()),
            names(&compare::peak()),
            names(&table::totals()),
            names(&table::drawn()),
        ]
        .concat();
        assert!(all.len() > 150, "{}", all.len());
        let unit_of = |shown| if let Shown::In(dimension) = shown { Some(dimension) } else { None };
        let units: Vec<_> = all.iter().filter_map(|(_, shown)| unit_of(*shown)).collect();
        for (name, shown) in all {
            // the longest end that is a unit: "_m_per_s" ends in "_s" too
            let ends = units.iter().filter(|unit| name.ends_with(unit.suffix()));
            let unit = ends.max_by_key(|unit| unit.suffix().len());
            assert_eq!(unit_of(shown).as_ref(), unit, "{name}");
        }
    }
}
