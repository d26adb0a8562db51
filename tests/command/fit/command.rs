//! `fit-plm` as a command: the file that it writes.

use super::{FITTED, reference};
use crate::common::prelude::*;

#[test]
fn the_command_writes_a_file_that_a_scenario_takes() {
    let desk = Desk::with("");
    let names: Vec<String> = (1..=5).map(|case| format!("case{case}.csv")).collect();
    for (case, name) in (1..).zip(&names) {
        fs::copy(reference(case), desk.path(name)).unwrap();
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let (table, _) = desk.ends(&[&["fit-plm"], &names[..], &["-o", "mine.toml", "--name", "PLM of mine"]].concat(), 0);
    assert!(names.iter().all(|name| table.contains(name)) && table.contains("left out"), "{table}");

    let toml = desk.read("mine.toml");
    let table = PlmCoefficients::from_toml(&toml).unwrap();
    assert_eq!(table.provenance.name, "PLM of mine");
    assert!(table.provenance.source.contains("5 loading curves: plm-impact fit-plm case1.csv"), "{toml}");
    assert!(table.provenance.range.contains("0.48"), "{toml}");
    // the file has the fitted coefficients to ten digits
    assert_relative_eq!(table.force.slope[4], FITTED.coefficients.force.slope[4], max_relative = 1e-9);

    let scenario = include_str!("../../../scenarios/steel-on-steel.toml")
        .replace("[law.plm]", "[law.plm]\ncoefficients = \"mine.toml\"");
    fs::write(desk.path("s.toml"), scenario).unwrap();
    desk.ends(&["run", "s.toml", "--pictures", "none"], 0);
    assert!(desk.read("plots/s/summary.json").contains("PLM of mine"));
}
