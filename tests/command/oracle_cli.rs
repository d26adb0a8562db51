//! Every row of `src/reference/oracle.csv` through the command, with the default solver.

use std::fs;

use assert_cmd::Command;
use rayon::prelude::*;
use tempfile::TempDir;

/// The quantities that are compared, by their names in the summary, and their columns in the reference.
const QUANTITIES: [(&str, usize); 5] = [
    ("restitution", 10),
    ("contact_time_s", 11),
    ("peak_force_N", 13),
    ("residual_indentation_m", 15),
    ("yield_speed_m_per_s", 19),
];

/// The scenario of a row: its numbers as they are written, in SI units, without a table of the solver.
fn scenario(row: &csv::StringRecord) -> String {
    let exponent = match &row[9] {
        name @ "pressure-shape" => format!("{name:?}"),
        number => number.to_string(),
    };
    format!(
        "[sphere]\nradius = {}\nyoungs_modulus = {}\npoissons_ratio = {}\ndensity = {}\n\n\
         [half_space]\nyoungs_modulus = {}\npoissons_ratio = {}\nyield_strength = {}\n\n\
         [impact]\nspeed = {}\n\n[law.plm]\nunloading_exponent = {exponent}\n",
        &row[1], &row[2], &row[3], &row[4], &row[5], &row[6], &row[7], &row[8],
    )
}

#[test]
fn the_command_reproduces_the_oracle_at_its_defaults() {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(include_str!("../../src/reference/oracle.csv").as_bytes());
    let headers = reader.headers().unwrap().clone();
    for (name, column) in QUANTITIES {
        assert_eq!(&headers[column], name);
    }
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 18);
    rows.par_iter().for_each(|row| {
        let directory = TempDir::new().unwrap();
        let (file, out) = (directory.path().join("scenario.toml"), directory.path().join("out"));
        fs::write(&file, scenario(row)).unwrap();
        Command::new(env!("CARGO_BIN_EXE_plm-impact"))
            .arg("run")
            .arg(&file)
            .arg("--out")
            .arg(&out)
            .arg("--quiet")
            .assert()
            .success()
            .stdout("");

        let summary: serde_json::Value = serde_json::from_slice(&fs::read(out.join("summary.json")).unwrap()).unwrap();
        for (name, column) in QUANTITIES {
            let got = summary[name].as_f64().unwrap_or_else(|| panic!("{}: no number {name}", &row[0]));
            let want: f64 = row[column].parse().unwrap();
            // in a row without a dent the difference has to be exactly 0
            let miss = (got - want).abs();
            assert!(miss <= 1e-8 * want, "{} ({}): {name} = {got:e}, not {want:e}", &row[0], &row[9]);
        }
    });
}
