//! Parquet tables of many row groups, compared with the CSV table and for different numbers of threads. Tested with the
//! command as a process.

use std::fs::File;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

use crate::common::prelude::*;

const BASE: &str = r#"
sphere = { radius = "5 mm", youngs_modulus = "210 GPa", poissons_ratio = 0.3, density = "7850 kg/m^3" }
half_space = { youngs_modulus = "210 GPa", poissons_ratio = 0.3, yield_strength = "345 MPa" }
impact = { speed = "1 m/s" }
"#;

/// A grid with row groups of one law and of two laws, with results, failures, or both; the last word changes in every
/// row.
const GRID: &str = r#"
[sweep]
"law" = ["plm", "thornton"]
"impact.speed" = { logspace = [1e-3, 1e200], points = 15_000 }
"solver.method" = ["closed_form", "auto"]
"#;

const RANDOM: &str = r#"
[monte_carlo]
samples = 70_000
"impact.speed" = { uniform = [1, 2] }
"half_space.yield_strength" = { lognormal = { mean = 345e6, sd = 30e6 } }
"#;

/// Runs a sweep, which ends with this code.
fn run(tables: &str, code: i32, arguments: &[&str]) -> Sandbox {
    let desk = Sandbox::with(format!("{BASE}{tables}"));
    desk.run_expecting(&[&["run", "s.toml", "--out", "out", "--pictures", "none"], arguments].concat(), code);
    desk
}

/// Compares every field, and returns the number of row groups.
fn compare(csv: &Path, parquet: &Path) -> usize {
    let mut csv = csv::Reader::from_path(csv).unwrap();
    let reader = SerializedFileReader::new(File::open(parquet).unwrap()).unwrap();
    let mut rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    for record in csv.records().map(Result::unwrap) {
        let row = rows.next().unwrap();
        assert_eq!(row.len(), record.len());
        for ((name, field), text) in row.get_column_iter().zip(&record) {
            let is_same = match field {
                Field::Null => text.is_empty(),
                Field::Double(value) => text.parse() == Ok(*value),
                Field::Long(value) => text.parse() == Ok(*value),
                Field::Str(value) => text == value,
                _ => false,
            };
            assert!(is_same, "{name}: {field} against {text}");
        }
    }
    assert!(rows.next().is_none());
    reader.num_row_groups()
}

#[test]
fn row_groups_match_the_csv_table() {
    for (tables, code) in [(GRID, 1), (RANDOM, 0)] {
        let (csv, parquet) = (run(tables, code, &[]), run(tables, code, &["--format", "parquet"]));
        let row_groups = compare(&csv.path("out/table.csv"), &parquet.path("out/table.parquet"));
        assert!(row_groups > 0, "{row_groups} row groups");
        // the summaries have to be the same, except for the command and the name of the table
        let summaries = [&csv, &parquet].map(|desk| {
            let mut summary = desk.summary();
            let provenance = summary["provenance"].as_object_mut().unwrap();
            assert!(["command", "files"].iter().all(|name| provenance.remove(*name).is_some()));
            summary
        });
        assert_eq!(summaries[0], summaries[1]);
    }
}

#[test]
fn bytes_are_independent_of_thread_number() {
    for (tables, code) in [(GRID, 1), (RANDOM, 0)] {
        let table = |threads: &str| {
            let desk = run(tables, code, &["--format", "parquet", "--threads", threads]);
            fs::read(desk.path("out/table.parquet")).unwrap()
        };
        let one = table("1");
        assert!(one == table("2") && one == table("7"));
    }
}

/// The table of contents has the range of each column in a row group, so a reader can skip row groups.
#[test]
fn row_groups_state_range_of_their_numbers() {
    let desk = run(RANDOM, 0, &["--format", "parquet"]);
    let reader = SerializedFileReader::new(File::open(desk.path("out/table.parquet")).unwrap()).unwrap();
    let mut next = 0;
    for group in reader.metadata().row_groups() {
        let parquet::file::statistics::Statistics::Int64(cases) = group.column(0).statistics().unwrap() else {
            panic!("cases are whole numbers")
        };
        assert_eq!(cases.min_opt(), Some(&next));
        next += group.num_rows();
        assert_eq!(cases.max_opt(), Some(&(next - 1)));
    }
    assert_eq!(next, 70_000);
}
