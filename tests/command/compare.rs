//! Laws in the command: scenarios, sweeps over laws, the comparison of Figure 10, the list of laws.

use std::path::Path;

use plm_impact::law::LawChoice;

use crate::common::command::{Desk, column, numbers};
use crate::common::off;

const BODIES: &str = r#"
[sphere]
radius = "35 mm"
youngs_modulus = "208 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
[half_space]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_strength = "345 MPa"
"#;

/// The scenario of Figure 10 at this many yield indentations.
fn shipped(depth: &str) -> String {
    let name = format!("scenarios/figure-10-at-{depth}-yield-indentations.toml");
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

#[test]
fn every_law_of_a_sweep_has_its_rows_and_those_without_an_answer_are_no_failures() {
    let whole: Vec<String> = LawChoice::all().iter().filter(|law| law.has_loading()).map(LawChoice::name).collect();
    let list: Vec<String> =
        whole.iter().chain(["jackson_green + brake".to_owned()].iter()).map(|name| format!("{name:?}")).collect();
    let text = format!(
        "[impact]\nspeed = 1\n[sweep]\nlaw = [{}]\n\"impact.speed\" = {{ logspace = [1e-3, 10], points = 9 }}",
        list.join(", ")
    );
    let desk = Desk::ran(format!("{BODIES}{text}"));
    let table = desk.read("out/table.csv");
    let (laws, status, e) = (column(&table, "law"), column(&table, "status"), column(&table, "restitution"));
    assert_eq!(laws.len(), 9 * list.len());
    for ((law, status), e) in laws.iter().zip(&status).zip(&e) {
        match status.as_str() {
            "ok" => assert!(e.parse::<f64>().unwrap() <= 1.0 + 1e-12, "{law} {e}"),
            "outside_law" => assert!(["mesarovic_johnson", "johnson", "stronge"].contains(&law.as_str()), "{law}"),
            other => panic!("{law}: {other}"),
        }
    }
    assert!(status.iter().any(|status| status == "outside_law"));
    let outside = status.iter().filter(|status| *status == "outside_law").count();
    let summary = desk.summary();
    assert_eq!(summary["outside_law"], outside);
    assert_eq!(summary["failures"], 0);
    // the rows of the PLM have the same bits as in a table of the PLM alone
    let alone = "[impact]\nspeed = 1\n[sweep]\n\"impact.speed\" = { logspace = [1e-3, 10], points = 9 }";
    let alone = Desk::ran(format!("{BODIES}{alone}")).read("out/table.csv");
    assert!(!alone.contains("law"));
    let of_plm: Vec<String> = laws.iter().zip(&e).filter(|(law, _)| *law == "plm").map(|(_, e)| e.clone()).collect();
    assert_eq!(column(&alone, "restitution"), of_plm);
}

#[test]
fn swept_laws_by_rk8_agree_with_the_closed_form() {
    let rows = |method: &str| {
        let text = format!(
            "[impact]\nspeed = 1\n[solver]\nmethod = \"{method}\"\n[sweep]\n\"impact.speed\" = [0.005, 0.5, 5]\nlaw = [\"plm\", \"jackson_green\", \"kogut_etsion\", \"mesarovic_johnson\", \"thornton\", \"kogut_etsion + mesarovic_johnson\"]"
        );
        let table = Desk::ran(format!("{BODIES}{text}")).read("out/table.csv");
        (numbers(&table, "restitution"), column(&table, "status"))
    };
    let (exact, stepped) = (rows("closed_form"), rows("rk8"));
    assert_eq!(exact.1, stepped.1);
    for (a, b) in exact.0.iter().zip(&stepped.0).filter(|(a, _)| a.is_finite()) {
        // ten times the tolerance, 1e-10
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
}

#[test]
fn figure_10_compares_every_law_with_the_finite_elements() {
    // e by the law of the paper against finite elements with the same peak: expected from the exponent are −0.9 to −4.5
    // %
    for (name, depth) in [("13", 13.4969), ("105", 105.086), ("843", 843.257)] {
        let desk = Desk::with(shipped(name));
        let (text, _) = desk.ends(&["run", "s.toml", "--out", "out"], 0);
        assert!(text.contains("mesarovic_johnson") && text.contains("against FE"), "{text}");
        let (table, summary) = (desk.read("out/comparison.csv"), desk.summary());
        let laws = column(&table, "law");
        assert_eq!(laws[..2], ["finite_elements", "plm"]);
        assert_eq!(laws.len(), 12);
        let number = |column_name: &str, law: &str| -> f64 {
            column(&table, column_name)[laws.iter().position(|name| name == law).unwrap()].parse().unwrap()
        };
        let of_plm = number("restitution_deviation", "plm");
        assert!((-0.045..-0.009).contains(&of_plm), "{name}: {of_plm}");
        assert!(number("residual_deviation", "plm").abs() < 0.01);
        // the file gives the peak of the finite elements, so the energies are those of their table
        let recovered =
            number("restitution", "finite_elements").powi(2) * summary["peak"]["spent_work_J"].as_f64().unwrap();
        assert!(off(recovered, number("recovered_energy_J", "finite_elements")) < 1e-3);
        assert!((summary["peak"]["indentation_over_yield"].as_f64().unwrap() / depth - 1.0).abs() < 1e-12);
        assert_eq!(summary["provenance"]["scenario_sha256"].as_str().unwrap().len(), 64);
        assert!(summary["provenance"]["scenario_file"].is_string());
        // the residual indentation by Eq. 23, from the peak and the indentation of the sphere
        let peak = &summary["peak"];
        let residual =
            peak["indentation_m"].as_f64().unwrap() - peak["sphere_indentation_m"].as_f64().unwrap() / sphere_share();
        assert!((number("residual_indentation_m", "plm") / residual - 1.0).abs() < 1e-9);
        assert!(desk.path("out/unloading.png").exists());
    }
}

/// κ = E*/E_s* of case 3.
fn sphere_share() -> f64 {
    (1.0 / 208.0) / (1.0 / 208.0 + 1.0 / 210.0)
}

#[test]
fn a_peak_from_the_plm_unloads_by_the_plm_as_an_impact_does() {
    let bodies = BODIES.replace("density = \"7850 kg/m^3\"\n", "");
    let scenario = format!("{bodies}[compare]\npeak_indentation_ratio = 105.1\nlaws = [\"plm\", \"thornton\"]");
    let table = Desk::ran(scenario).read("out/comparison.csv");
    let e = numbers(&table, "restitution")[1];
    // independent table for case 3: δ_r/δ_m = 0.700834, e = 0.5160391763
    assert!((e - 0.516_039_176_3).abs() < 1e-9, "{e}");
    let share = numbers(&table, "residual_share")[1];
    assert!((share - 0.700_834).abs() < 1e-6, "{share}");
}

#[test]
fn laws_lists_every_law_and_those_that_are_missing() {
    let (text, _) = Desk::with("").ends(&["laws"], 0);
    for name in LawChoice::names() {
        assert!(text.contains(&format!("\n{name}\n")), "{name}");
    }
    for missing in [
        "PLM's own unloading",
        "Kogut and Komvopoulos 2004, unloading",
        "MYC",
        "CYM",
        "Rathbone",
        "Du and Wang",
        "Zhao",
        "Dong",
        "Chen",
    ] {
        assert!(text.contains(missing), "{missing}");
    }
    assert_eq!(text.matches("confidence").count(), LawChoice::names().len());
}

#[test]
fn check_says_what_is_compared_and_for_which_bodies() {
    let (text, _) = Desk::with(shipped("13")).ends(&["check", "s.toml"], 0);
    // case 3 of Table 1 of the paper: delta_Y by Eq. 17
    for wanted in [
        "peak as given",
        "0.035 m (35 mm)",
        "(345 MPa)",
        "kappa",
        "2.02848 µm",
        "law.plm.unloading_exponent",
        "thornton",
    ] {
        assert!(text.contains(wanted), "{wanted}: {text}");
    }
}
