//! Laws in the command: sweeps over laws, the list of laws.

use crate::common::prelude::*;

#[test]
fn law_sweep_has_rows_for_every_law() {
    let whole: Vec<String> = LawChoice::all().iter().filter(|law| law.has_loading()).map(LawChoice::name).collect();
    let list: Vec<String> =
        whole.iter().chain(["jackson_green + brake".to_owned()].iter()).map(|name| format!("{name:?}")).collect();
    let text =
        format!("[sweep]\nlaw = [{}]\n\"impact.speed\" = {{ logspace = [1e-3, 10], points = 9 }}", list.join(", "));
    let desk = Sandbox::with_results(format!("{STEEL}{text}"));
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

#[test]
fn laws_lists_available_and_missing_laws() {
    let (text, _) = Sandbox::with("").run_expecting(&["laws"], 0);
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
fn laws_as_json_have_facts_of_all() {
    let (text, _) = Sandbox::with("").run_expecting(&["laws", "--json"], 0);
    let all: Value = serde_json::from_str(&text).unwrap();
    let laws = all["laws"].as_array().unwrap();
    let names: Vec<&str> = laws.iter().map(|law| law["name"].as_str().unwrap()).collect();
    assert_eq!(names, LawChoice::names());
    for key in ["title", "source", "loading", "unloading", "validity", "confidence"] {
        assert!(laws.iter().all(|law| law[key].as_str().is_some_and(|text| !text.is_empty())), "{key}");
    }
    assert!(
        all["not_here"].as_array().unwrap().iter().all(|law| law["title"].is_string() && law["reason"].is_string())
    );
}
