//! Parquet tables of many row groups, compared with the CSV table and for different numbers of threads. Tested with the
//! command as a process.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

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

/// Runs a sweep in a directory of its own, and returns the exit code.
fn run(tables: &str, out: &Path, arguments: &[&str]) -> Option<i32> {
    fs::create_dir_all(out).unwrap();
    let file = out.join("scenario.toml");
    fs::write(&file, format!("{BASE}{tables}")).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
    command.arg("run").args(arguments).arg("--out").args([out, &file]).stderr(Stdio::null()).stdout(Stdio::null());
    command.status().unwrap().code()
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
fn row_groups_hold_what_the_csv_table_holds() {
    for (tables, code) in [(GRID, 1), (RANDOM, 0)] {
        let directory = tempfile::tempdir().unwrap();
        let (csv, parquet) = (directory.path().join("csv"), directory.path().join("parquet"));
        assert_eq!(run(tables, &csv, &[]), Some(code));
        assert_eq!(run(tables, &parquet, &["--format", "parquet"]), Some(code));
        let row_groups = compare(&csv.join("table.csv"), &parquet.join("table.parquet"));
        assert!(row_groups > 0, "{row_groups} row groups");
        // the summaries have to be the same, except for the command and the place of the scenario
        let summary = |out: &Path| {
            let text = fs::read_to_string(out.join("summary.json")).unwrap();
            let mut summary: serde_json::Value = serde_json::from_str(&text).unwrap();
            for of_run in ["command", "scenario_file"] {
                summary["provenance"].as_object_mut().unwrap().remove(of_run).unwrap();
            }
            summary
        };
        assert_eq!(summary(&csv), summary(&parquet));
    }
}

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    for (tables, code) in [(GRID, 1), (RANDOM, 0)] {
        let directory = tempfile::tempdir().unwrap();
        let table = |threads: &str| {
            let out = directory.path().join(threads);
            assert_eq!(run(tables, &out, &["--format", "parquet", "--threads", threads]), Some(code));
            fs::read(out.join("table.parquet")).unwrap()
        };
        let one = table("1");
        assert!(one == table("2") && one == table("7"));
    }
}

/// The table of contents has the range of each column in a row group, so a reader can skip row groups.
#[test]
fn row_groups_tell_the_range_of_their_numbers() {
    let directory = tempfile::tempdir().unwrap();
    assert_eq!(run(RANDOM, directory.path(), &["--format", "parquet"]), Some(0));
    let reader = SerializedFileReader::new(File::open(directory.path().join("table.parquet")).unwrap()).unwrap();
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
