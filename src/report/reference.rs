//! The reference page: every key, every result, every material.

use crate::scenario::reference::{keys, materials};
use crate::scene::results;

/// A part of a page that the program writes: its name, and its text.
type Part = (&'static str, fn() -> String);

const PARTS: [Part; 3] = [("keys", keys), ("results", results), ("materials", materials)];

/// A page with the text between the marks written anew.
///
/// # Errors
/// The marks that the page lacks.
pub fn renewed(page: &str) -> Result<String, [String; 2]> {
    let write = |page: String, (name, text): &Part| {
        let begin = format!("<!-- {name}: written by a test -->");
        let end = format!("<!-- end of {name} -->");
        let parts = page.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?.1)));
        let Some((before, after)) = parts else { return Err([begin, end]) };
        Ok(format!("{before}{begin}\n\n{}{end}{after}", text()))
    };
    PARTS.iter().try_fold(page.to_owned(), write)
}

/// All results as Markdown.
fn results() -> String {
    results::files() + &super::calibrate::files()
}
