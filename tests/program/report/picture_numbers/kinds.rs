//! No function that makes a picture is left out.

use std::collections::BTreeSet;

use super::*;

/// Pictures that are read in a way of their own: the map by its colours, and the regions of two keys by their outline. The tests of
/// `check-trace` and `peen` read the words of theirs.
const READ_ELSEWHERE: [&str; 4] = [
    "contact_trace::contact_trace",
    "heatmap::heatmap",
    "posterior::posterior_chart",
    "process_window::process_window",
];

/// Times are other ones in every run, and the bench writes them as PNG alone.
const NOT_READ: [&str; 1] = ["report::picture"];

/// File and name of each function in these folders that makes a picture.
fn kinds(folder: &Path) -> BTreeSet<String> {
    let mut kinds = BTreeSet::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            kinds.extend(self::kinds(&entry));
            continue;
        }
        let (file, text) =
            (entry.file_stem().unwrap().to_string_lossy(), fs::read_to_string(&entry).unwrap_or_default());
        let mut function = "";
        for line in text.lines() {
            if let Some((_, rest)) = line.split_once("fn ") {
                function = rest.split(['(', '<']).next().unwrap_or_default();
            }
            if line.contains("Chart::new(") || line.contains("Chart::with_panels(") {
                kinds.insert(format!("{file}::{function}"));
            }
        }
    }
    kinds
}

fn drawings() -> impl Iterator<Item = &'static Drawing> {
    [&runs::ALL, &calibration::ALL, &validation::ALL].into_iter().flat_map(|drawings| drawings.iter())
}

#[test]
fn every_kind_of_picture_is_read_back() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let made: BTreeSet<String> = ["src/report", "src/validate", "src/bench", "src/interfaces"]
        .into_iter()
        .flat_map(|folder| kinds(&root.join(folder)))
        .collect();
    let read: BTreeSet<String> = drawings()
        .flat_map(|drawing| &drawing.shown)
        .map(|shown| shown.kind.to_owned())
        .chain(READ_ELSEWHERE.into_iter().chain(NOT_READ).map(str::to_owned))
        .collect();
    assert_eq!(made, read);
}

/// This finds also a picture that is drawn by a helper function.
#[test]
fn every_written_picture_is_read_back() {
    let written: BTreeSet<&str> = drawings().flat_map(|drawing| drawing.results.pictures()).collect();
    let read: BTreeSet<&str> = drawings().flat_map(|drawing| &drawing.shown).map(|shown| shown.picture).collect();
    let not_read: Vec<&str> = written.difference(&read).copied().collect();
    assert_eq!(not_read, ["posterior"]);
}
