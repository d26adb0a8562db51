//! The tables of the reference pages (`scenarios/keys.md`, `results.md`, `materials.md`): every key, every result, every material.
//! A test of the program writes them into the pages.

use crate::scenario::reference::keys;
use crate::units::markdown;

/// A part of a page that the program writes: its name, and its text.
type Part = (&'static str, fn() -> String);

const PARTS: [Part; 3] = [("keys", keys), ("results", results), ("materials", materials)];

/// A page in which every table between two marks is written anew, and the number of these tables. The marks are comments such as
/// `<!-- keys: written by a test -->`.
pub fn renewed(page: &str) -> (String, usize) {
    let mut count = 0;
    let write = |page: String, (name, text): &Part| {
        let begin = format!("<!-- {name}: written by a test -->");
        let end = format!("<!-- end of {name} -->");
        let parts = page.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?.1)));
        let Some((before, after)) = parts else { return page };
        count += 1;
        format!("{before}{begin}\n\n{}{end}{after}", text())
    };
    (PARTS.iter().fold(page.to_owned(), write), count)
}

fn materials() -> String {
    markdown(&super::materials::rows("")) + "\n"
}

/// All results as Markdown, a table for every file, or part of one, that has them.
fn results() -> String {
    super::results().into_iter().map(|(markdown, _)| markdown).collect()
}

#[cfg(test)]
mod tests {
    use crate::scenario::scene::results::Shown;

    #[test]
    fn a_name_ends_in_the_unit_of_its_number_and_no_other_name_does() {
        let all: Vec<_> = super::super::results().into_iter().flat_map(|(_, names)| names).collect();
        assert!(all.len() > 200, "{}", all.len());
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
