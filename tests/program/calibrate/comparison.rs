//! A calibration with nothing to find: measurements beside the law.

use super::fits::{assert_close, run_calibration};
use crate::common::prelude::*;

const LEEB: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/leeb-d.toml");

/// Device D on 300 HV, to be compared with data.
fn leeb() -> String {
    let text = fs::read_to_string(LEEB).unwrap();
    let bodies = text.replace("[impact]\nspeed = \"2 m/s\"\n", "");
    format!("{bodies}[calibrate]\ndata = \"d.csv\"\nfree = {{}}\n")
}

fn of_leeb(speed: f64, set: &[String]) -> f64 {
    let scene = Scenario::load(LEEB.as_ref(), &Override::list(set)).unwrap().resolve().unwrap();
    let impact = scene.contact().unwrap().row(speed, &Solver::AUTO).unwrap();
    impact.restitution_with_waves().unwrap_or(impact.restitution)
}

/// The law gives what a scenario with the same keys gives, and residuals, misfit and chi-square follow from that by hand.
#[test]
fn measurements_stand_beside_the_law() {
    let data = "note,speed_m_per_s,restitution_sd,restitution\n1,2,0.01,0.54\n2,1.0,0.05,0.6\n3,0.5,0.2,0.7\n";
    let (desk, summary) = run_calibration(&leeb(), data, &super::fits::SVG_PICTURES, 0);
    let law = numbers(&desk.read("o/residuals.csv"), "predicted");
    for (got, speed) in law.iter().zip([2.0, 1.0, 0.5]) {
        assert!(relative_error(*got, of_leeb(speed, &[])) < 1e-14, "{got}");
    }
    let measured = [(0.54, 0.01), (0.6, 0.05), (0.7, 0.2)];
    let square = |(law, (measured, sd)): (&f64, (f64, f64))| ((measured - law) / sd).powi(2);
    assert_close(&summary["chi_square"], law.iter().zip(measured).map(square).sum(), 1e-12);
    assert_eq!((&summary["degrees_of_freedom"], &summary["keys"]), (&json!(3), &json!([])));
    assert_eq!((&summary["fits"], &summary["refusal"]), (&json!(true), &Value::Null));
    let off = |(law, (measured, _)): (&f64, (f64, f64))| (measured - law).powi(2);
    let misfit = law.iter().zip(measured).map(off).sum::<f64>() / measured.map(|one| one.0 * one.0).iter().sum::<f64>();
    assert_close(&summary["misfit"], misfit.sqrt(), 1e-12);
    assert_eq!(desk.files("o"), ["fit_restitution.svg", "residuals.csv", "residuals.svg", "summary.json"]);
}

/// Student's distribution with 4 degrees of freedom has the density 3/8 (1 + r²/4)^(−5/2) at r standard deviations. Values beyond
/// three standard deviations are outliers: chi-square and its degrees of freedom are those of the other values.
#[test]
fn outliers_have_likelihood_of_student_distribution() {
    let data = super::table::data("outliers");
    let robust = "data = \"d.csv\"\nfree = {}\nnoise = { restitution = 0.01 }\nrobust = \"student-t\"\n";
    let (desk, summary) = run_calibration(&super::fits::scenario(robust), &data, &[], 0);
    let table = desk.read("o/residuals.csv");
    let (measured, law) = (numbers(&table, "measured"), numbers(&table, "predicted"));
    let squares: Vec<f64> = measured.iter().zip(&law).map(|(read, law)| ((read - law) / 0.01).powi(2)).collect();
    let term = |square: &f64| 2.0 * f64::ln(8.0 / 3.0 * 0.01) + 5.0 * f64::ln(1.0 + square / 4.0);
    assert_close(&summary["aic"], squares.iter().map(term).sum(), 1e-9);
    let inliers: Vec<f64> = squares.into_iter().filter(|square| *square <= 9.0).collect();
    assert_eq!((inliers.len(), &summary["outliers"], &summary["degrees_of_freedom"]), (8, &json!(2), &json!(8)));
    assert_close(&summary["chi_square"], inliers.iter().sum(), 1e-9);
}

/// A model error alone is the standard deviation of every value, as a share of what the law gives.
#[test]
fn model_error_alone_is_share_of_law() {
    let text = leeb().replace("free = {}", "free = {}\nnoise = { model = 0.05 }");
    let (desk, summary) = run_calibration(&text, "speed_m_per_s,restitution\n2,0.54\n1.0,0.6\n0.5,0.7\n", &[], 0);
    let law = numbers(&desk.read("o/residuals.csv"), "predicted");
    let square = |(law, measured): (&f64, f64)| ((measured - law) / (0.05 * law)).powi(2);
    assert_close(&summary["chi_square"], law.iter().zip([0.54, 0.6, 0.7]).map(square).sum(), 1e-12);
}

/// Keys may change from line to line, also those of a plate.
#[test]
fn the_thickness_of_a_plate_is_a_column() {
    let data = "speed_m_per_s,half_space_thickness_m,restitution\n2,0.05,0.5\n2,0.02,0.5\n1,0.008,0.4\n";
    let text = leeb().replace("[half_space]", "[half_space]\nplate = \"thick\"");
    let table = run_calibration(&text, data, &[], 0).0.read("o/residuals.csv");
    for (law, (speed, thickness)) in numbers(&table, "predicted").iter().zip([(2.0, 0.05), (2.0, 0.02), (1.0, 0.008)]) {
        let set = [format!("half_space.thickness={thickness}"), "half_space.plate=thick".to_owned()];
        let want = of_leeb(speed, &set);
        assert!(relative_error(*law, want) < 1e-14, "{law} {want}");
    }
}

/// The fitted law between two points of an unloading is the law, which bends there with its exponent, and not a chord. The key
/// says that the standard deviation is estimated.
#[test]
fn fitted_law_is_drawn_as_curve() {
    let data = "indentation_um,force_N\n5,60\n20,370\n15,60\n";
    let text = super::fits::scenario("data = \"d.csv\"\nfree = {}\n");
    let (desk, _) = run_calibration(&text, data, &["--pictures", "svg"], 0);
    let svg = desk.read("o/fit_force.svg");
    let document = Document::parse(&svg).unwrap();
    let corners = document.descendants().filter(|node| node.has_tag_name("polyline"));
    let longest = corners.filter_map(|node| Some(node.attribute("points")?.split_whitespace().count())).max();
    assert!(longest.unwrap() > 80, "{longest:?}");
    assert!(svg.contains("with the estimated") && !svg.contains("with its"));
}

/// No sentence says what it does not mean: a law that does not know the strength has no best strength, and an end that the data
/// leave open is not a number.
#[test]
fn undetermined_results_are_omitted() {
    let text = super::fits::scenario(&format!("data = \"d.csv\"\n{}", super::fits::STRENGTH));
    let desk = Sandbox::with(text);
    desk.write("d.csv", super::fits::restitutions());
    let said = desk.run(&["calibrate", "s.toml", "--all-laws", "--out", "o", "--pictures", "none"]);
    let said = String::from_utf8(said.stdout).unwrap();
    let of_springs = said.lines().find(|line| line.starts_with("walton_braun")).unwrap();
    assert!(of_springs.contains("not identified"), "{said}");
}
