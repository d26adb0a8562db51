//! `[output] columns`: a table with fewer results, and the output of `check` for a sweep. Tested with the command as a
//! process.

use crate::common::prelude::*;

/// A scenario without `[output]`, which tests can add, and without a yield strength.
const ELASTIC: &str = r#"
[sphere]
radius = "5 mm"
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
[impact]
speed = "1 m/s"
[half_space]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
"#;
const YIELDING: &str = "yield_strength = \"345 MPa\"\n";
const SWEEP: &str = "[sweep]\n\"impact.speed\" = { logspace = [\"1 mm/s\", \"10 m/s\"], points = 21 }\n";

fn table(text: &str) -> Vec<Vec<String>> {
    let table = Desk::ran(text).read("out/table.csv");
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(table.as_bytes());
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

#[test]
fn a_table_has_the_columns_named_and_the_same_digits() {
    let whole = table(&format!("{ELASTIC}{YIELDING}{SWEEP}"));
    let chosen = r#"["dent_radius_m", "peak_force_N"]"#;
    let few = table(&format!("{ELASTIC}{YIELDING}{SWEEP}[output]\ncolumns = {chosen}\n"));
    let want = ["case", "impact_speed_m_per_s", "restitution", "peak_force_N", "dent_radius_m", "status"];
    assert_eq!(few[0], want);
    let places: Vec<usize> = want.iter().map(|name| whole[0].iter().position(|other| other == name).unwrap()).collect();
    assert_eq!(few.len(), whole.len());
    for (few, whole) in few.iter().zip(&whole) {
        let same: Vec<&String> = places.iter().map(|place| &whole[*place]).collect();
        assert_eq!(few.iter().collect::<Vec<_>>(), same);
    }
}
