//! The built-in coefficients and the unloading law against finite elements: not exact, but as close as documented.
#![allow(clippy::unwrap_used)]

mod common;

use std::collections::BTreeMap;

use common::Scene;
use plm_impact::impact::Method;
use plm_impact::law::{Law, UnloadingExponent};
use plm_impact::material::Material;

/// A row of a reference table, by column.
type Row = BTreeMap<String, String>;

fn rows(text: &str) -> Vec<Row> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(Result::unwrap).collect()
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap()
}

fn scene(row: &Row) -> Scene {
    let with = |body: &str| {
        let poissons_ratio = row.get(&format!("{body}_poissons_ratio")).map_or(0.3, |text| text.parse().unwrap());
        Material { youngs_modulus: number(row, &format!("{body}_youngs_modulus_Pa")), poissons_ratio }
    };
    Scene {
        sphere: with("sphere"),
        half_space: with("half_space"),
        yield_strength: Some(number(row, "yield_strength_Pa")),
        ..Scene::case_3()
    }
}

/// Mean, root mean square and the two ends of relative deviations.
struct Deviations {
    mean: f64,
    rms: f64,
    least: f64,
    most: f64,
}

impl Deviations {
    fn of(deviations: &[f64]) -> Self {
        #[allow(clippy::cast_precision_loss)]
        let n = deviations.len() as f64;
        Self {
            mean: deviations.iter().sum::<f64>() / n,
            rms: (deviations.iter().map(|d| d * d).sum::<f64>() / n).sqrt(),
            least: deviations.iter().copied().fold(f64::INFINITY, f64::min),
            most: deviations.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        }
    }

    fn print(&self, what: &str) {
        let [mean, rms, least, most] = [self.mean, self.rms, self.least, self.most].map(|d| 100.0 * d);
        println!("{what}: mean {mean:+.2} %, rms {rms:.2} %, {least:+.2} to {most:+.2} %");
    }
}

fn loading() -> BTreeMap<String, Vec<Row>> {
    let mut cases: BTreeMap<String, Vec<Row>> = BTreeMap::new();
    for row in rows(include_str!("reference/fe_loading.csv")) {
        cases.entry(row["case"].clone()).or_default().push(row);
    }
    assert_eq!(cases.len(), 5);
    cases
}

#[test]
fn loading_force_is_within_the_documented_deviation() {
    let mut worst: f64 = 0.0;
    for (case, rows) in loading() {
        let law = scene(&rows[0]).law();
        let deviations: Vec<f64> =
            rows.iter().map(|row| law.loading.force(number(row, "x")) / number(row, "f") - 1.0).collect();
        let found = Deviations::of(&deviations);
        found.print(&format!("force, {case}"));
        // documented: rms 0.7 to 1.4 % per case, largest 3.5 %
        assert!(found.rms < 0.0145, "{case}");
        worst = worst.max(found.most).max(-found.least);
    }
    assert!(worst < 0.035, "{worst}");
}

#[test]
fn elastic_approach_is_within_the_documented_deviation() {
    for (case, rows) in loading() {
        // case 5, the rigid sphere: its δ_s is a thousandth of δ_e and lost in the finite elements' digits
        if case == "case5" {
            continue;
        }
        let scene = scene(&rows[0]);
        let (law, kappa) = (scene.law(), scene.contact().pair().sphere_compliance);
        let deviations: Vec<f64> = rows
            .iter()
            .map(|row| {
                let x = number(row, "x");
                law.loaded_to(x).elastic_approach * kappa / (x * number(row, "sphere_share")) - 1.0
            })
            .collect();
        let found = Deviations::of(&deviations);
        found.print(&format!("elastic approach, {case}"));
        // documented: rms 0.6 to 1.2 %
        assert!(found.rms < 0.012, "{case}");
    }
}

#[test]
fn residual_indentation_follows_from_the_peak() {
    // Eq. 23 with the finite elements' own peak state, δ_r = δ_m − (E_s*/E*) δ_sm
    for row in rows(include_str!("reference/fe_unloading.csv")) {
        let kappa = scene(&row).contact().pair().sphere_compliance;
        let residual = 1.0 - number(&row, "sphere_share") / kappa;
        let deviation = residual / number(&row, "residual_share") - 1.0;
        // documented: below 1 %, 1.3 % at a/R of 0.42 to 0.46 (case 4, deep); at x = 3 the shallow dent itself is known to 5 %
        let allowed = match number(&row, "x") {
            x if x < 5.0 => 0.05,
            x if row["case"] == "case4" && x > 30.0 => 0.0135,
            _ => 0.01,
        };
        assert!(deviation.abs() < allowed, "{} at {}: {deviation:+.4}", row["run"], row["x"]);
    }
}

fn restitution(law: &Law, x: f64) -> f64 {
    (law.unloading(law.loaded_to(x)).stored(x) / law.loading.work(x)).sqrt()
}

#[test]
fn restitution_of_load_cycles_is_within_the_documented_deviation() {
    let table = rows(include_str!("reference/fe_unloading.csv"));
    assert_eq!(table.len(), 59);
    let deviations = |exponent: UnloadingExponent| {
        let deviation = |row: &Row| {
            let law = Law { exponent, ..scene(row).law() };
            restitution(&law, number(row, "x")) / number(row, "restitution") - 1.0
        };
        Deviations::of(&table.iter().map(deviation).collect::<Vec<_>>())
    };
    let paper = deviations(UnloadingExponent::Paper);
    paper.print("restitution of cycles, exponent 3/2");
    // documented: mean −2.9 %, −5.5 to −0.7 %; the spent work is integrated anew here, which moves each by a tenth or two
    assert!((paper.mean + 0.029).abs() < 0.002 && paper.least > -0.057 && paper.most < -0.005);
    let shape = deviations(UnloadingExponent::PressureShape);
    shape.print("restitution of cycles, pressure-shape");
    // documented: mean −0.4 %, rms 0.95 %, −2.5 to +1.9 %
    assert!((shape.mean + 0.004).abs() < 0.002 && shape.rms < 0.0115 && shape.least > -0.027 && shape.most < 0.021);
}

#[test]
fn whole_impacts_are_within_the_documented_deviation() {
    for row in rows(include_str!("reference/fe_dynamic.csv")) {
        for exponent in [UnloadingExponent::Paper, UnloadingExponent::PressureShape] {
            let scene =
                Scene { radius: 5e-3, density: number(&row, "sphere_density_kg_per_m3"), exponent, ..scene(&row) };
            let impact = scene.impact(number(&row, "impact_speed_m_per_s"), Method::Rk8, 1e-10, None);
            let off = |got: f64, column: &str| got / number(&row, column) - 1.0;
            let restitution = off(impact.restitution, "restitution");
            // documented over these and other impacts
            let documented = match exponent {
                UnloadingExponent::Paper => -0.028..=-0.011,
                _ => 0.004..=0.021,
            };
            assert!(documented.contains(&restitution), "{} {exponent:?}: e {restitution:+.4}", row["case"]);
            assert!(off(impact.contact_time, "contact_time_s").abs() < 0.014, "{}", row["case"]);
            assert!(off(impact.residual_indentation, "residual_indentation_m").abs() < 0.02, "{}", row["case"]);
            // the loading curve's own deviation, 3.5 %, at most
            assert!(off(impact.peak_force, "peak_force_N").abs() < 0.035, "{}", row["case"]);
            if exponent == UnloadingExponent::PressureShape {
                // what is left is what the waves took: documented −0.7 to +0.8 %
                let kept = impact.restitution.powi(2) - 0.01 * number(&row, "radiated_percent");
                assert!(off(kept.sqrt(), "restitution").abs() < 0.009, "{}", row["case"]);
            }
        }
    }
}
