//! Drops on a plate: the strength comes back from references of another program, from the results of a table, and from one drop.

use std::fmt::Write as _;

use super::fits::{STRENGTH, assert_close, bounds, run_calibration};
use crate::common::prelude::*;
use crate::common::reference::rows;

const REFERENCES: &str = include_str!("../../reference/plate.csv");
const NOISE: &str = "[calibrate]\ndata = \"d.csv\"\nnoise = { model = 0.01 }\n";

/// A ball of 10 mm diameter on a plate of 10 mm.
const PLATE: &str = "[sphere]\nradius = \"5 mm\"\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\ndensity = 7850\n\
    [half_space]\nyoungs_modulus = \"70 GPa\"\npoissons_ratio = 0.33\ndensity = 2700\nyield_strength = \"345 MPa\"\n\
    thickness = \"10 mm\"\nplate = \"thick\"\n";

/// Three impacts of a sphere of 5 mm diameter on steel of 345 MPa, at Zener's numbers of 0.002 to 1.2, integrated with 30 digits
/// by another program. Every line has its own thickness.
#[test]
fn references_with_30_digits_give_their_strength() {
    let all = rows(REFERENCES);
    let chosen: Vec<_> = ["ep-2", "ep-4", "ep-5"].map(|name| all.iter().find(|row| row.name() == name).unwrap()).into();
    let text = "[sphere]\nradius = 0.0025\nyoungs_modulus = \"208 GPa\"\npoissons_ratio = 0.3\ndensity = 7850\n\
        [half_space]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\ndensity = 7850\nyield_strength = \"1 GPa\"\n[law.plm]\n";
    let text = text.to_owned() + super::fits::NINE_PIECE_COEFFICIENTS + NOISE;
    for quantity in ["restitution", "contact_time_s", "peak_force_N"] {
        let mut data = format!("speed_m_per_s,half_space_thickness_m,{quantity}\n");
        for row in &chosen {
            assert_eq!(row.number("half_space.yield_strength"), 345e6);
            let [speed, thickness] = ["impact.speed", "half_space.thickness"].map(|key| row.number(key));
            writeln!(data, "{speed},{thickness},{}", row.cell_text(quantity)).unwrap();
        }
        let (_, summary) = run_calibration(&text, &data, &[], 0);
        assert_close(&summary["keys"][0]["estimate"], 345e6, 1e-6);
    }
}

/// A table over the speed, under two theories and another law.
#[test]
fn a_table_on_a_plate_gives_its_strength() {
    for more in ["", "[law.thornton]\n", "[law.plm]\nunloading_exponent = \"pressure-shape\"\n"] {
        let of_theory = PLATE.replace("thick\"\n", if more.is_empty() { "zener\"\n" } else { "thick\"\n" });
        let sweep = "[sweep]\n\"impact.speed\" = { logspace = [0.05, 5.0], points = 12 }\n";
        let table = Sandbox::with_results(format!("{of_theory}{more}{sweep}")).read("out/table.csv");
        for (result, quantity) in [("restitution", "restitution"), ("dent_diameter_m", "dent_diameter_m")] {
            let columns = ["impact_speed_m_per_s", result];
            let data = super::fits::pairs(&table, columns, &format!("speed_m_per_s,{quantity}"));
            let text = format!("{}{more}{NOISE}{STRENGTH}", of_theory.replace("345 MPa", "900 MPa"));
            let (desk, summary) = run_calibration(&text, &data, &[], 0);
            assert_close(&summary["keys"][0]["estimate"], 345e6, 1e-6);
            // the residuals are rounding, whatever their signs
            let (_, said) = desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"], 0);
            assert!(!said.contains("residuals are not random"), "{said}");
        }
    }
}

/// One drop, and the height of its rebound by `run`. On a block the same height would need another strength.
#[test]
fn one_drop_on_a_plate_gives_its_strength() {
    let text = format!("{PLATE}[impact]\ndrop_height = \"1 m\"\n");
    let height = Sandbox::with_results(&text).summary()["rebound_height_m"].as_f64().unwrap().to_string();
    let drop = ["--drop-height", "1 m", "--rebound-height", &height];
    let (desk, summary) = run_calibration(&text.replace("345 MPa", "200 MPa"), "", &drop, 0);
    assert_close(&summary["keys"][0]["estimate"], 345e6, 1e-6);
    desk.run_expecting(&["run", "o/calibrated.toml", "--out", "p", "--pictures", "none"], 0);
    assert_close(&desk.json("p/summary.json")["rebound_height_m"], height.parse().unwrap(), 1e-6);
    let block = text.replace("thickness = \"10 mm\"\nplate = \"thick\"\n", "");
    let (_, summary) = run_calibration(&block, "", &drop, 0);
    assert!(summary["keys"][0]["estimate"].as_f64().unwrap() < 250e6, "{summary}");
}

/// The standard deviation is one over the root of the sum of (de/dσ)²/sd², with derivatives from the contact itself; the interval
/// of 95 % has nearly 1.96 of it on both sides. Every law is ranked.
#[test]
fn interval_on_plate_follows_from_derivatives() {
    let (speeds, sd) = ([0.5, 1.0, 2.0, 4.0], 0.005);
    let e = |strength: f64, speed: f64| {
        let set = [format!("half_space.yield_strength={strength}"), format!("impact.speed={speed}")];
        contact(PLATE, &set).row(speed, &Solver::AUTO).unwrap().restitution
    };
    let data = speeds.iter().fold("speed_m_per_s,restitution\n".to_owned(), |data, speed| {
        data + &format!("{speed},{}\n", e(345e6, *speed))
    });
    let text = format!("{PLATE}[calibrate]\ndata = \"d.csv\"\nnoise = {{ restitution = {sd} }}\n");
    let (desk, summary) = run_calibration(&text, &data, &["--all-laws", "--pictures", "svg"], 0);
    let slope = |speed: &f64| (e(346e6, *speed) - e(344e6, *speed)) / 2e6 / sd;
    let wanted = 1.0 / speeds.iter().map(|speed| slope(speed).powi(2)).sum::<f64>().sqrt();
    assert_close(&summary["keys"][0]["sd"], wanted, 1e-2);
    let [low, high] = bounds(&summary["keys"][0]["interval_95"]).map(|end| end.as_f64().unwrap());
    assert!(relative_error(high - low, 2.0 * 1.96 * wanted) < 0.05, "{low} {high} {wanted}");
    let laws = summary["laws"].as_array().unwrap();
    assert!(laws[0]["law"] == "plm" && laws.iter().all(|law| law["no_answer"].is_null()), "{laws:?}");
    assert!(desk.path("o/fit_restitution.svg").exists() && desk.path("o/laws.svg").exists());
}

/// On a plate the warnings of `run` are given for the impacts at the ends of the data, with their line.
#[test]
fn a_plate_is_warned_of() {
    let places = [(1.0, 10.0), (3.0, 10.0), (3.0, 2.0)];
    let e = |(speed, thickness): (f64, f64)| {
        let set = ["half_space.yield_strength=200 MPa".to_owned(), format!("half_space.thickness={thickness} mm")];
        contact(PLATE, &[&set[..], &[format!("impact.speed={speed}")]].concat()).row(speed, &Solver::AUTO).unwrap()
    };
    let data = places.iter().fold("speed_m_per_s,half_space_thickness_mm,restitution\n".to_owned(), |data, place| {
        data + &format!("{},{},{}\n", place.0, place.1, e(*place).restitution)
    });
    let desk = Sandbox::with(PLATE.replace("thickness = \"10 mm\"\n", "edge_distance = \"3 cm\"\n") + NOISE);
    desk.write("d.csv", data);
    let (_, said) = desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"], 0);
    let line = |warning: &str| said.lines().find(|line| line.contains(warning)).unwrap_or_else(|| panic!("{said}"));
    assert!(line("half_space.edge_distance").contains("at line 2 of the data"), "{said}");
    assert!(line("Contact radius / plate thickness").contains("at line 4 of the data"), "{said}");
}
