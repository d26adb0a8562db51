//! Laws in the command: scenarios, sweeps over laws, the comparison of Figure 10, the list of laws.

use crate::common::prelude::*;

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
    let text =
        format!("[sweep]\nlaw = [{}]\n\"impact.speed\" = {{ logspace = [1e-3, 10], points = 9 }}", list.join(", "));
    let desk = Desk::ran(format!("{STEEL}{text}"));
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
}

/// The numbers of the comparison are in tests/same_numbers; here, what they say of the law.
#[test]
fn figure_10_compares_every_law_with_the_finite_elements() {
    // e by the law of the paper against finite elements with the same peak: expected from the exponent are −0.9 to −4.5
    // %
    for name in ["13", "105", "843"] {
        let desk = Desk::with(shipped(name));
        let (text, _) = desk.ends(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
        assert!(text.contains("mesarovic_johnson") && text.contains("against FE"), "{text}");
        let (table, summary) = (desk.read("out/comparison.csv"), desk.summary());
        let laws = column(&table, "law");
        assert!(laws[..2] == ["finite_elements", "plm"] && laws.len() == 12, "{laws:?}");
        let number = |name: &str, law: usize| numbers(&table, name)[law];
        let of_plm = number("restitution_deviation", 1);
        assert!((-0.045..-0.009).contains(&of_plm), "{name}: {of_plm}");
        assert!(number("residual_deviation", 1).abs() < 0.01);
        // the file gives the peak of the finite elements, so the energies are those of their table
        let recovered = number("restitution", 0).powi(2) * summary["peak"]["spent_work_J"].as_f64().unwrap();
        assert!(off(recovered, number("recovered_energy_J", 0)) < 1e-3);
    }
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
