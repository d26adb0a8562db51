//! Texts about a run: files, and tables for the terminal. Nothing here opens a file or prints.

pub(crate) mod calibrate;
pub(crate) mod checked;
pub(crate) mod indentation;
pub mod inputs;
pub mod laws;
pub mod materials;
pub(crate) mod overview;
pub(crate) mod plan;
pub mod reference;
pub(crate) mod repeat;
pub(crate) mod rows;
pub(crate) mod series;
pub(crate) mod summary;
pub mod sweep;
mod terminal;

use crate::scenario::scene::results::impact;
pub use rows::trace;
pub use summary::summary;
pub use terminal::{Detail, impact as table};

/// All results as Markdown, a table for every file, or part of one, that has them.
fn results() -> String {
    [impact::files(), series::files(), indentation::files(), sweep::files(), calibrate::files(), checked::files()]
        .concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::scene::results::{Reported, Shown};

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
            names(&indentation::columns()),
            names(&sweep::totals()),
            names(&sweep::drawn()),
            names(&checked::contact()),
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
