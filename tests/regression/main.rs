//! Checks that no number of the program has moved.
//!
//! This test is for changes that must not move any number, such as a redesign. It runs the command on every scenario of
//! `scenarios/`, on the scenarios of this folder with many keys set in turn (`runs.rs`), and on `validate`.
//! It takes all results of all files that they write (`numbers.rs`), and compares them with `record.json`. No value may
//! move by more than 1e-12 of the largest value of its column; counts of steps, words and empty cells may not change.
//! Sums of rounding, such as the error of the energy balance, may move by 1e-12 of what they are a share of.
//!
//! The record has a line for every column of every file of every run (for JSON, a column is a path of keys). A column
//! with one row stands there as it is. A longer one stands there as its number of rows, the mean magnitude, which sees
//! all values move together, and a sum in which each row has a weight of its own, which sees any one of them move
//! (`record.rs`). If the test fails, it names run, file and column. Columns that are not in the record are ignored; those in the record
//! must exist. A new scenario must be recorded.
//!
//! If numbers have to change, write the record again, and say in the commit which numbers changed, why, and how much:
//!
//! ```sh
//! UPDATE=1 cargo test --test regression
//! ```

#![allow(clippy::unwrap_used)]

#[allow(dead_code, reason = "the record is compared with a tolerance")]
#[path = "../common/golden.rs"]
mod golden;
mod numbers;
mod record;
mod runs;

use std::fs;
use std::path::Path;

use numbers::{Cell, Columns};
use rayon::prelude::*;
use record::{Record, Runs};

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");

#[test]
fn results_match_the_record() {
    let runs = runs::all();
    let summaries = |run: &runs::Run| record::summaries(&numbers::columns(Path::new(PROGRAM), run));
    let now: Runs = runs.par_iter().map(|run| (run.name.clone(), summaries(run))).collect();
    assert_eq!(now.len(), runs.len(), "two runs have the same name");
    let path = runs::folder("tests/regression/record.json");
    let differences = record::differences(&record::read(&fs::read_to_string(&path).unwrap()), &now);
    // a record whose numbers hold is kept, as its last digits are rounding
    if golden::is_updating() && !differences.is_empty() {
        return fs::write(&path, record::to_text(&now)).unwrap();
    }
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

fn columns(cells: Vec<Cell>) -> Columns {
    [(("trace.csv".to_owned(), "force_N".to_owned()), cells)].into()
}

fn numbers_of(numbers: &[f64]) -> Columns {
    columns(numbers.iter().map(|number| Cell::Number(*number)).collect())
}

fn runs_of(columns: &Columns) -> Runs {
    [("a run".to_owned(), record::summaries(columns))].into()
}

/// Writes the record of these columns, and reads it back.
fn recorded(columns: &Columns) -> Record {
    record::read(&record::to_text(&runs_of(columns)))
}

/// The record sees 1e-11 of the largest value in any one value, in any number of rows, and lets 1e-13 of it pass.
#[test]
fn record_detects_changed_numbers() {
    for rows in [1_u32, 2, 3, 20, 1000, 100_000] {
        let before: Vec<f64> = (0..rows).map(|row| 1e7 * f64::from(row + 1).sqrt().sin()).collect();
        let record = recorded(&numbers_of(&before));
        assert!(record::differences(&record, &runs_of(&numbers_of(&before))).is_empty(), "{rows} rows read back");
        let largest = before.iter().map(|value| value.abs()).fold(0.0, f64::max);
        let with = |change: &dyn Fn(usize, f64) -> f64| {
            let after: Vec<f64> = before.iter().enumerate().map(|(row, value)| change(row, *value)).collect();
            record::differences(&record, &runs_of(&numbers_of(&after))).len()
        };
        let places = [0, 1, 2, 13, 500, 77_777, before.len() - 1];
        for place in places.into_iter().filter(|place| *place < before.len()) {
            let by = |share: f64| with(&|row, value| if row == place { value + share * largest } else { value });
            for moved in [1e-11, -1e-11, 1.5e-12, 1e-3, 1e3] {
                assert_eq!(by(moved), 1, "{rows} rows, row {place} moved by {moved}");
            }
            assert_eq!(by(1e-13) + by(-1e-13), 0, "{rows} rows, row {place} moved by rounding");
        }
        for moved in [1e-11, -1e-11, 1.5e-12] {
            assert_eq!(with(&|_, value| value * (1.0 + moved)), 1, "{rows} rows, all moved by {moved}");
        }
        assert_eq!(with(&|_, value| value * (1.0 + 1e-15)), 0, "{rows} rows, all moved by rounding");
    }
}

/// Rows that change places, a changed sign, a missing row, a word, a missing column and a missing run are seen. A new
/// column is ignored, and so is the size of what is zero but for rounding.
#[test]
fn record_detects_structural_changes() {
    let before = numbers_of(&[1.0, 3.0, -2.0, 5.0]);
    let [with_nan, with_gap] = [Cell::Word("NaN".to_owned()), Cell::Empty]
        .map(|cell| columns([cell, Cell::Number(3.0), Cell::Number(-2.0), Cell::Number(5.0)].into()));
    let changed = [
        numbers_of(&[1.0, 3.0, 2.0, 5.0]),
        numbers_of(&[1.0, -2.0, 3.0, 5.0]),
        numbers_of(&[1.0, 3.0, -2.0]),
        numbers_of(&[1.0]),
        with_nan,
        with_gap,
        Columns::new(),
    ];
    for after in &changed {
        assert_eq!(record::differences(&recorded(&before), &runs_of(after)).len(), 1, "{after:?}");
    }
    assert_eq!(record::differences(&recorded(&before), &Runs::new()).len(), 1);
    assert_eq!(record::differences(&Record::new(), &runs_of(&before)).len(), 1);

    let words = |word: &str| columns(vec![Cell::Word(word.to_owned()), Cell::Word("ok".to_owned())]);
    assert_eq!(record::differences(&recorded(&words("ok")), &runs_of(&words("captured"))).len(), 1);
    let word = |word: &str| columns(vec![Cell::Word(word.to_owned())]);
    assert_eq!(record::differences(&recorded(&word("ok")), &runs_of(&word("captured"))).len(), 1);

    let mut more = before.clone();
    more.insert(("trace.csv".to_owned(), "new".to_owned()), vec![Cell::Empty]);
    assert!(record::differences(&recorded(&before), &runs_of(&more)).is_empty());

    let [zero, tiny] = [&[0.0, 0.0], &[0.0, 1e-20]].map(|numbers| numbers_of(numbers));
    assert_eq!(record::differences(&recorded(&zero), &runs_of(&tiny)).len(), 1);
    assert_eq!(record::differences(&recorded(&tiny), &runs_of(&zero)).len(), 1);

    let balance_error = |size: f64| -> Columns {
        [(("summary.json".to_owned(), "energy.balance_error".to_owned()), vec![Cell::Number(size)])].into()
    };
    assert!(record::differences(&recorded(&balance_error(3e-16)), &runs_of(&balance_error(-2e-15))).is_empty());
    assert_eq!(record::differences(&recorded(&balance_error(3e-16)), &runs_of(&balance_error(3e-12))).len(), 1);
}
