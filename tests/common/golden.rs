//! Golden files: files of the repository that a test compares with what the program makes. `UPDATE=1 cargo test` writes them
//! anew; read the difference before you commit it.

use std::fs;
use std::path::Path;

/// Whether this run of the tests writes golden files anew.
pub fn is_updating() -> bool {
    std::env::var_os("UPDATE").is_some_and(|value| value == "1")
}

/// Asserts that a golden file is what was just made, or writes the file anew.
#[track_caller]
pub fn assert_golden(path: &Path, made: impl AsRef<[u8]>) {
    let made = made.as_ref();
    if is_updating() {
        return fs::write(path, made).unwrap();
    }
    assert!(fs::read(path).unwrap() == made, "{} is stale: UPDATE=1 cargo test writes it anew", path.display());
}

/// Asserts that the part of a page between its two comments (`<!-- limits: written by a test -->`, `<!-- end of limits -->`) is what
/// was just made, or writes the part anew.
#[track_caller]
#[allow(dead_code)] // tests/capi.rs has no page with parts
pub fn assert_golden_part(page: &Path, name: &str, made: &str) {
    let [begin, end] = [format!("<!-- {name}: written by a test -->\n"), format!("<!-- end of {name} -->")];
    let text = fs::read_to_string(page).unwrap();
    let (before, rest) = text.split_once(&begin).unwrap();
    let (_, after) = rest.split_once(&end).unwrap();
    assert_golden(page, format!("{before}{begin}\n{made}\n{end}{after}"));
}
