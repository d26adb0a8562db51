//! `[half_space.rate]` and `[sphere.rate]` through the interfaces: warnings, materials, tables, series, a calibration.

use std::fmt::Write as _;

use plm_impact::units::{Dimension, format_si_and_short};

use crate::common::prelude::*;

fn with_rate(rate: &str) -> String {
    STEEL.replace("[impact]", &format!("[half_space.rate]\n{rate}\n[impact]"))
}

const COOK: &str = "johnson_cook = { c = 0.02 }";

/// The metal's rate is taken where it is asked for; where it is not, `check` says how much higher e is with it.
#[test]
fn material_gives_rate_only_on_request() {
    let copper = STEEL.replace("yield_strength = \"345 MPa\"", "material = \"copper-annealed\"");
    let asked = copper.replace("[impact]", "rate = \"material\"\n[impact]");
    let e = |text: &str| scene(text, NO_OVERRIDES).contact().unwrap().closed_form(3.0).unwrap().row.restitution;
    let by_key = copper.replace("[impact]", "rate.johnson_cook.c = 0.025\n[impact]");
    assert_eq!(e(&asked).to_bits(), e(&by_key).to_bits());
    assert_eq!(number_of_key(&scene(&copper, NO_OVERRIDES), "half_space.rate.johnson_cook.c"), None);
    let higher = 100.0 * (e(&asked) / e(&copper) - 1.0);
    let (said, _) = Sandbox::with(&copper).run_expecting(&["check", "s.toml"], 0);
    let line =
        said.lines().find(|line| line.starts_with("Hint: with the strain-rate dependence of copper-annealed")).unwrap();
    let number: f64 = line.split("e is ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((number - higher).abs() < 0.01 && line.ends_with("half_space.rate = \"material\"."), "{line} {higher}");
    let (said, _) = Sandbox::with(&asked).run_expecting(&["check", "s.toml"], 0);
    assert!(!said.contains("with the strain-rate dependence of") && said.contains("strain-rate factor"), "{said}");
    // the yield point that is printed, and that of the JSON, are those at the strain rate of the speed
    let (json, _) = Sandbox::with(&asked).run_expecting(&["check", "s.toml", "--json"], 0);
    let json: Value = serde_json::from_str(&json).unwrap();
    let own = scene(&asked, NO_OVERRIDES).contact().unwrap().at_speed(3.0).unwrap().into_owned();
    let force = own.pair().yield_point.unwrap().force;
    assert_eq!(json["contact"]["yield_force_N"], force);
    assert!(said.contains(&format_si_and_short(force, Dimension::Force)), "{said}");
}

/// Every row of a table has the strength of its own speed, on a grid and drawn, with its columns.
#[test]
fn rows_have_their_own_rates() {
    let table = Sandbox::with_results(
        with_rate(COOK)
            + "[sweep]\n\"impact.speed\" = [0.001, 0.3, 3]\n\"half_space.rate.johnson_cook.c\" = [0, 0.02]\n",
    );
    let table = table.read("out/table.csv");
    let [e, factor, turn, rate] =
        ["restitution", "rate_factor", "rate_factor_at_peak", "strain_rate_per_s"].map(|name| numbers(&table, name));
    for (place, speed) in [0.001, 0.001, 0.3, 0.3, 3.0, 3.0].into_iter().enumerate() {
        let c = if place % 2 == 0 { 0.0 } else { 0.02 };
        let alone = scene(&with_rate(&format!("johnson_cook = {{ c = {c} }}")), NO_OVERRIDES).contact().unwrap();
        let alone = alone.row(speed, &Solver::AUTO).unwrap();
        let rated = alone.strain_rate_result.unwrap();
        assert_eq!(e[place].to_bits(), alone.restitution.to_bits());
        assert_eq!([factor[place], turn[place], rate[place]], [rated.factor, rated.factor_at_peak, rated.strain_rate]);
    }
    let drawn = with_rate(COOK)
        + "[monte_carlo]\nsamples = 5\n\"half_space.rate.johnson_cook.c\" = { uniform = [0.01, 0.03] }\n";
    let desk = Sandbox::with_results(drawn);
    let table = desk.read("out/table.csv");
    let (c, e) = (numbers(&table, "half_space_rate_johnson_cook_c"), numbers(&table, "restitution"));
    for (c, e) in c.iter().zip(e) {
        let alone = scene(&with_rate(&format!("johnson_cook = {{ c = {c:e} }}")), NO_OVERRIDES).contact().unwrap();
        assert_eq!(alone.row(3.0, &Solver::AUTO).unwrap().restitution.to_bits(), e.to_bits());
    }
}

/// In a series every impact has its own factor; the files of a single impact show the relaxation.
#[test]
fn a_series_and_a_trace_have_the_rate() {
    let shots = with_rate(COOK).split("[impact]").next().unwrap().to_owned();
    let desk = Sandbox::with_results(shots + "[repeat]\nspot = \"same\"\nspeeds = [1, 3, 0.5, 5]\n");
    let impacts = desk.read("out/impacts.csv");
    let dents = numbers(&impacts, "residual_indentation_m");
    assert!(dents[0] < dents[1] && dents[1] == dents[2] && dents[2] < dents[3], "{dents:?}");
    let desk = Sandbox::with_results(with_rate(COOK));
    assert!(desk.read("out/trace.csv").contains("relaxation"));
    let summary = desk.summary();
    assert!(summary["rate_factor"].as_f64().unwrap() > summary["rate_factor_at_peak"].as_f64().unwrap());
    assert_eq!(summary["inputs"]["half_space_rate_tested_at_per_s"], 0.001);
    let lines = desk.run_expecting(&["export", "s.toml", "--to", "lammps"], 0).0;
    assert_eq!(lines.matches("the strength depends on the strain rate").count(), 1, "{lines}");
}

/// Rate and strength together do not follow from restitutions, and the refusal says why.
#[test]
fn rate_and_strength_are_not_fitted_together() {
    let contact = scene(&with_rate("johnson_cook = { c = 0.014 }"), NO_OVERRIDES).contact().unwrap();
    let mut data = "speed_m_per_s,restitution\n".to_owned();
    for speed in [0.3, 0.5, 1.0, 2.0, 3.0, 5.0] {
        writeln!(data, "{speed},{}", contact.closed_form(speed).unwrap().row.restitution).unwrap();
    }
    let bodies = STEEL.split("yield_strength").next().unwrap();
    let free = "[calibrate]\ndata = \"d.csv\"\nnoise.restitution = 0.005\n[calibrate.free]\n\
                \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"1 GPa\" }\n\
                \"half_space.rate.johnson_cook.c\" = { from = 0.001, to = 0.05 }\n";
    let desk = Sandbox::with(format!("{bodies}{free}"));
    fs::write(desk.path("d.csv"), data).unwrap();
    let (_, said) = desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"], 0);
    assert!(said.contains("cannot identify the keys separately") && said.contains("0.7 % per decade"), "{said}");
}
