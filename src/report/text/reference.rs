//! The reference pages: every key, every result, every material.

use super::results;
use crate::scenario::reference::keys;
use crate::units::aligned::markdown;

/// A part of a page that the program writes: its name, and its text.
type Part = (&'static str, fn() -> String);

const PARTS: [Part; 3] = [("keys", keys), ("results", results), ("materials", materials)];

/// A page with the text between the marks written anew, and how many pairs of marks it has.
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

/// All materials as Markdown.
fn materials() -> String {
    markdown(&super::materials::rows("")) + "\n"
}
