//! Checks that no number of the program has changed.
//!
//! This test is for changes that must not change any number, such as a redesign. It runs the command on every scenario
//! of `scenarios/`, on the scenarios of this folder with many keys set in turn (`runs.rs`), on `validate` and on
//! `fit-plm`. It takes all numbers of all files that they write (`numbers.rs`), and compares them to the last bit with
//! `tests/same_numbers/record.csv`. Counts of steps and of evaluations are compared like all other numbers.
//!
//! The record has a line for every column of every file (for JSON, every path of keys): the number of rows, the first
//! and the last value, the sum, and a digest of the bits of all values. Run and file are written only on lines where
//! they change. If the test fails, it names run, file and column, and says how much the first value, the last value or
//! the sum changed. Columns and keys that are not in the record are ignored; those in the record must exist. A new
//! scenario must be recorded.
//!
//! If numbers have to change, write the record again, and say in the commit which numbers changed, why, and how much:
//!
//! ```sh
//! PLM_IMPACT_RECORD=write cargo test --test same_numbers
//! ```
//!
//! To see how much all numbers changed, compare with the earlier program in full digits. The comparison fails if any
//! number differs, and lists the largest difference for every column:
//!
//! ```sh
//! PLM_IMPACT_OTHER=path/to/the/old/plm-impact cargo test --test same_numbers -- --ignored
//! ```

#![allow(clippy::unwrap_used)]

mod numbers;
mod other;
mod record;
mod runs;

use std::path::{Path, PathBuf};

use numbers::{Cell, Columns};
use rayon::prelude::*;
use record::Record;

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");

#[test]
fn every_number_is_that_of_the_record() {
    let runs = runs::all();
    let summaries = |run: &runs::Run| record::summaries(&numbers::columns(Path::new(PROGRAM), run));
    let now: Record = runs.par_iter().map(|run| (run.name.clone(), summaries(run))).collect();
    assert_eq!(now.len(), runs.len(), "two runs have the same name");
    let path = runs::folder("tests/same_numbers/record.csv");
    match std::env::var("PLM_IMPACT_RECORD").ok().as_deref() {
        None => refuse(&record::differences(&record::read(&path), &now)),
        Some("write") => {
            record::write(&path, &now);
            assert!(record::read(&path) == now, "the record does not read back as it was written");
        }
        Some(other) => panic!("PLM_IMPACT_RECORD is \"{other}\": leave it out, or set it to \"write\""),
    }
}

#[test]
#[ignore = "needs another program, PLM_IMPACT_OTHER"]
fn every_number_is_that_of_the_other_program() {
    let other = std::env::var_os("PLM_IMPACT_OTHER").expect("PLM_IMPACT_OTHER is the path of the other plm-impact");
    let other = PathBuf::from(other).canonicalize().expect("PLM_IMPACT_OTHER must be the path of a program");
    let differences = |run: &runs::Run| {
        let [theirs, ours] = [&other, Path::new(PROGRAM)].map(|program| numbers::columns(program, run));
        other::differences(&run.name, &theirs, &ours)
    };
    let differences: Vec<_> = runs::all().par_iter().flat_map_iter(differences).collect();
    refuse(&differences);
}

fn refuse(differences: &[String]) {
    let list = differences.join("\n");
    assert!(
        differences.is_empty(),
        "{} columns differ:\n{list}\n{} columns differ",
        differences.len(),
        differences.len()
    );
}

/// The comparisons notice one changed bit, a missing row, a missing column and a missing run. They ignore a new column.
#[test]
fn what_differs_is_seen() {
    let place = ("trace.csv".to_owned(), "force_N".to_owned());
    let of = |numbers: &[f64]| -> Columns {
        [(place.clone(), numbers.iter().map(|number| Cell::Number(*number)).collect())].into()
    };
    let recorded = |columns: &Columns| -> Record { [("a run".to_owned(), record::summaries(columns))].into() };
    let before = of(&[1.0, 3.0, -0.0, 5.0]);
    let changed = [
        of(&[1.0, 3.0_f64.next_up(), -0.0, 5.0]),
        of(&[1.0, 3.0, 0.0, 5.0]),
        of(&[1.0, -0.0, 3.0, 5.0]),
        of(&[1.0, 3.0, -0.0]),
        of(&[f64::NAN, 3.0, -0.0, 5.0]),
        Columns::new(),
    ];
    for after in &changed {
        assert_eq!(record::differences(&recorded(&before), &recorded(after)).len(), 1, "{after:?}");
        assert_eq!(other::differences("a run", &before, after).len(), 1, "{after:?}");
    }
    assert_eq!(record::differences(&recorded(&before), &Record::new()).len(), 1);
    assert_eq!(record::differences(&Record::new(), &recorded(&before)).len(), 1);

    let mut more = before.clone();
    more.insert(("trace.csv".to_owned(), "new".to_owned()), vec![Cell::Empty]);
    assert!(record::differences(&recorded(&before), &recorded(&more)).is_empty());
    assert!(other::differences("a run", &before, &more).is_empty());
}
