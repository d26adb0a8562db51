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
        assert!(row_groups > 4, "{row_groups} row groups");
        // the summaries have to be the same, except for the command
        let summary = |out: &Path| {
            let text = fs::read_to_string(out.join("summary.json")).unwrap();
            let mut summary: serde_json::Value = serde_json::from_str(&text).unwrap();
            summary["provenance"].as_object_mut().unwrap().remove("command").unwrap();
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

/// All rows of a file as text. The column that is not in the file gets the value in the name of the folder.
fn rows(file: &Path, column: &str, value: &str) -> Vec<String> {
    let reader = SerializedFileReader::new(File::open(file).unwrap()).unwrap();
    let row = |row: parquet::record::Row| {
        assert!(row.get_column_iter().all(|(name, _)| name != column));
        let text = row.get_column_iter().map(|(_, field)| field.to_string()).collect::<Vec<_>>().join(",");
        format!("{value}: {text}")
    };
    reader.get_row_iter(None).unwrap().map(|found| row(found.unwrap())).collect()
}

/// The axis that divides the table is the slowest, the fastest, or one between. The name of the second law has
/// characters that are not allowed in paths.
#[test]
fn a_divided_table_has_the_rows_of_the_whole_one() {
    let laws = r#"law = ["plm", "jackson_green + brake", "thornton"]"#;
    let speeds = r#""impact.speed" = { logspace = [1e-3, 1], points = 700 }"#;
    let strengths = r#""half_space.yield_strength" = [1e8, 2e8, 3e8]"#;
    for axes in [[laws, speeds, strengths], [speeds, laws, strengths], [speeds, strengths, laws]] {
        let tables = format!("[sweep]\n{}\n", axes.join("\n"));
        let directory = tempfile::tempdir().unwrap();
        let out = |name: &str| directory.path().join(name);
        assert_eq!(run(&tables, &out("one"), &["--format", "parquet"]), Some(0));
        assert_eq!(run(&tables, &out("many"), &["--partition-by", "law"]), Some(0));
        let whole = SerializedFileReader::new(File::open(out("one/table.parquet")).unwrap()).unwrap();
        for (name, law) in
            [("plm", "plm"), ("jackson_green%20%2B%20brake", "jackson_green + brake"), ("thornton", "thornton")]
        {
            let found = rows(&out(&format!("many/table-by-law/law={name}/part-0.parquet")), "law", law);
            let of_law = |row: &parquet::record::Row| {
                row.get_column_iter().any(|(_, field)| *field == Field::Str(law.to_owned()))
            };
            let text = |row: parquet::record::Row| {
                let kept = row.get_column_iter().filter(|(name, _)| *name != "law");
                format!("{law}: {}", kept.map(|(_, field)| field.to_string()).collect::<Vec<_>>().join(","))
            };
            let expected: Vec<String> =
                whole.get_row_iter(None).unwrap().map(Result::unwrap).filter(of_law).map(text).collect();
            assert_eq!(expected.len(), 2100);
            assert!(found == expected, "{name}");
        }
        let summary = |name: &str| {
            let text = fs::read_to_string(out(name).join("summary.json")).unwrap();
            let mut summary: serde_json::Value = serde_json::from_str(&text).unwrap();
            summary["provenance"].as_object_mut().unwrap().remove("command").unwrap();
            summary
        };
        assert_eq!(summary("one"), summary("many"));
    }
}

#[test]
fn a_divided_table_is_refused_where_it_would_mix_with_other_files_or_has_no_words_to_divide_by() {
    let tables = "[sweep]\n\"impact.speed\" = [1, 2]\nlaw = [\"plm\", \"thornton\"]\n";
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let table = out.join("table-by-law");
    let says = |tables: &str, arguments: &[&str]| {
        fs::create_dir_all(&out).unwrap();
        let file = directory.path().join("scenario.toml");
        fs::write(&file, format!("{BASE}{tables}")).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
        let output = command.arg("run").args(arguments).arg("--out").args([&out, &file]).output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    let (code, text) = says(tables, &["--partition-by", "impact.speed"]);
    assert_eq!(code, Some(2));
    assert!(
        text.contains("--partition-by impact.speed: a table is divided by an axis of words, here by law"),
        "{text}"
    );
    let (code, text) = says(RANDOM, &["--partition-by", "law"]);
    assert_eq!(code, Some(2));
    assert!(text.contains("no axis of this [sweep] has words"), "{text}");
    let (code, text) = says(tables, &["--partition-by", "law", "--format", "csv"]);
    assert_eq!(code, Some(2));
    assert!(text.contains("leave --format out"), "{text}");
    assert_eq!(says(tables, &["--partition-by", "law", "--shard", "0/2"]).0, Some(2));
    assert!(!table.exists(), "a refused run leaves folders");

    // the same table again is kept; a file of a law that was removed from the axis, or a file of the user, is refused
    assert_eq!(says(tables, &["--partition-by", "law"]), (Some(0), says(tables, &["--partition-by", "law"]).1));
    let fewer = "[sweep]\n\"impact.speed\" = [1, 2]\nlaw = [\"plm\"]\n";
    let (code, text) = says(fewer, &["--partition-by", "law"]);
    assert_eq!(code, Some(2));
    assert!(text.contains("law=thornton") && text.contains("is not of this table"), "{text}");
    fs::remove_dir_all(table.join("law=thornton")).unwrap();
    assert_eq!(says(fewer, &["--partition-by", "law"]).0, Some(0));
    fs::write(table.join("law=plm/notes.txt"), "mine").unwrap();
    let (code, text) = says(tables, &["--partition-by", "law"]);
    assert_eq!(code, Some(2));
    assert!(text.contains("notes.txt: is not of this table"), "{text}");
    assert!(!table.join("law=thornton").exists(), "a refused run leaves folders");
}
