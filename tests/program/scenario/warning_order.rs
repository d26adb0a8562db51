//! Results that are not to be used: what is said of them, and that it is said first.

use crate::common::prelude::*;

/// A ball of one material on another at 3 m/s, with further tables.
fn pair(sphere: &str, half_space: &str, more: &str) -> String {
    format!(
        "[sphere]\nradius = \"5 mm\"\nmaterial = \"{sphere}\"\n[half_space]\nmaterial = \"{half_space}\"\n{more}\n[impact]\nspeed = 3\n"
    )
}

/// The warnings of a check.
fn warned(text: &str) -> Vec<String> {
    run::check(&read(text, NO_OVERRIDES)).unwrap().warnings
}

const YIELDS: &str = "e is far too high: the sphere would yield";

#[test]
fn strict_refuses_sphere_that_yields_outside_laws() {
    // a key without effect is a warning too, and comes later; beside a half-space that hardens a harder sphere stays elastic
    let hardens = "flow_stress = { power = { exponent = 0.3 } }\n[friction]\ncoefficient = 0.1";
    let soft = pair("alumina-99.5", "steel-s235", &hardens.replace("flow_stress", "yield_strength = 1e8\nflow_stress"));
    let soft = soft.replace("alumina-99.5\"", "alumina-99.5\"\nyield_strength = 2e8");
    let tables = [
        ("", YIELDS.to_owned()),
        ("[sweep]\n\"impact.speed\" = [1, 3]\n", format!("at impact.speed = 3 m/s: {YIELDS}")),
        ("[repeat]\nspot = \"same\"\nimpacts = 2\n", format!("impact 1: {YIELDS}")),
    ];
    for (table, first) in tables {
        let text = soft.clone() + table;
        let text = if table.starts_with("[sweep]") { text.replace("speed = 3\n", "") } else { text };
        let desk = Sandbox::with(&text);
        let run = ["run", "s.toml", "--out", "out", "--quiet", "--pictures", "none"];
        let (_, said) = desk.run_expecting(&[&run[..], &["--strict"]].concat(), 1);
        assert!(said.starts_with(&format!("warning: {first}")), "{said}");
        assert!(!desk.path("out/summary.json").exists());
        let (_, said) = desk.run_expecting(&run, 0);
        assert!(said.starts_with(&format!("warning: {first}")), "{said}");
        assert!(desk.summary()["warnings"][0].as_str().unwrap().starts_with(&first));
    }
    // of a calibration only the open interval precedes, and not the warnings of air and waves
    let range = "{ from = \"90 MPa\", to = \"110 MPa\" }";
    let calibrate = format!("[calibrate]\ndata = \"d.csv\"\nfree = {{ \"half_space.yield_strength\" = {range} }}\n");
    let desk = Sandbox::with(soft.split("[friction]").next().unwrap().to_owned() + &calibrate);
    desk.write("d.csv", "drop_height_m,restitution\n200,0.3\n300,0.28\n");
    let (_, said) = desk.run_expecting(&["calibrate", "s.toml", "--out", "out", "--pictures", "none"], 0);
    let first = said.lines().find(|line| line.contains("at line 3 of the data: ")).unwrap();
    assert!(first.contains(&format!("data: {YIELDS}")), "{said}");
    // what is handed to another code says it too
    let (lines, _) = Sandbox::with(&soft).run_expecting(&["export", "s.toml", "--to", "lammps"], 0);
    assert!(lines.starts_with(&format!("# warning: {YIELDS}")), "{lines}");
}

#[test]
fn bias_of_hardness_without_exponent_is_number() {
    let guide = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/README.md")).unwrap();
    assert!(guide.contains(&format!("| {RESTITUTION_BIAS_TEXT} |")));
    let says = |half_space: &str, more: &str| {
        let said = warned(&pair("steel-52100-hardened", half_space, more));
        said.iter().any(|line| line.contains(&format!("e is {RESTITUTION_BIAS_TEXT}. half_space.material")))
    };
    assert!(says("steel-s235", "") && says("steel-s355", "hardness = \"180 HB\""));
    // an exponent is known, but another law does not take it
    assert!(!says("steel-304-annealed", "") && says("steel-304-annealed", "[law.thornton]"));
    // given here; a metal that hardens no more; a strength of one's own
    assert!(!says("steel-s235", "flow_stress.power.exponent = 0.2"));
    assert!(!says("steel-4140-qt", "") && !says("steel-s235", "yield_strength = \"400 MPa\""));

    // the numbers are those that the law with hardening gives, which finite elements confirm: e by the hardness alone over
    // e of the flow curve with the same hardness, at dents that are neither shallow nor beyond the law
    for (exponent, least, most) in [("0.1", 1.04, 1.10), ("0.3", 1.19, 1.35)] {
        let by_hardness = STEEL.replace("yield_strength = \"345 MPa\"", "hardness = \"180 HB\"");
        let flow = format!("half_space.flow_stress.power.exponent={exponent}");
        for speed in [0.5, 1.0, 3.0, 8.0] {
            let e = |set: &[&str]| contact(&by_hardness, set).closed_form(speed).unwrap().row.restitution;
            let bias = e(&[]) / e(&[&flow]);
            assert!((least..most).contains(&bias), "N = {exponent} at {speed} m/s: {bias}");
        }
    }
}
