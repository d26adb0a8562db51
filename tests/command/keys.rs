//! The registry of keys: its schema and its reference page agree with what the program reads.

use plm_impact::scenario::Scenario;
use plm_impact::scene::keys::every_key;
use plm_impact::scene::other_keys::List;
use plm_impact::scene::reference::renewed;
use plm_impact::scene::schema::schema;
use serde_json::Value;

use crate::common::STEEL;
use crate::common::command::{Desk, text};

/// A scenario as JSON.
fn json(text: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap()
}

#[test]
fn every_scenario_of_the_repository_keeps_to_the_schema() {
    // checked by the crate jsonschema, which is independent of this program
    let schema = jsonschema::validator_for(&schema()).unwrap();
    let mut count = 0;
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let scenario = json(&std::fs::read_to_string(&path).unwrap());
            let errors: Vec<String> =
                schema.iter_errors(&scenario).map(|error| format!("{}: {error}", error.instance_path())).collect();
            assert!(errors.is_empty(), "{}: {errors:?}", path.display());
            count += 1;
        }
    }
    assert!(count > 30, "{count}");
}

#[test]
fn every_list_of_tables_says_how_it_is_written() {
    for path in every_key().map(|key| key.path) {
        if let Some((list, _)) = path.split_once("[].") {
            assert!(List::find(list).is_some(), "{path}");
        }
    }
}

#[test]
fn what_the_schema_refuses_the_program_refuses_too() {
    let schema = jsonschema::validator_for(&schema()).unwrap();
    for (from, to) in [
        ("radius = \"5 mm\"", "raduis = \"5 mm\""),
        ("radius = \"5 mm\"", "radius = -5"),
        ("radius = \"5 mm\"", "radius = true"),
        ("poissons_ratio = 0.3\n", "poissons_ratio = 0.5\n"),
        ("[impact]", "[impakt]"),
        ("[impact]", "[law.plm]\n[law.hertz]\n[impact]"),
        ("[impact]", "[law.pml]\n[impact]"),
        ("[impact]", "[law.plm]\nunloading_exponent = 1\n[impact]"),
        ("[impact]", "[law.hertz]\nx = 1\n[impact]"),
        ("[impact]", "[solver]\nmethod = \"rk7\"\n[impact]"),
        ("[impact]", "[output]\nsamples = 1\n[impact]"),
        ("[impact]", "[sweep]\n\"impact.sped\" = [1]\n[impact]"),
        ("[impact]", "[sweep]\n\"impact.speed\" = { linspace = [1, 2] }\n[impact]"),
        ("[impact]", "[monte_carlo]\n\"impact.speed\" = { uniform = [1, 2] }\n[impact]"),
        ("[impact]", "[repeat]\nspot = \"some\"\n[impact]"),
        ("[impact]", "[indentation]\nsteps = [{ lode = 1 }]\n[impact]"),
    ] {
        let scenario = STEEL.replacen(from, to, 1);
        assert!(!schema.is_valid(&json(&scenario)), "{to}");
        let read = Scenario::from_text("steel.toml", &scenario, &[]);
        assert!(read.is_err(), "{to}");
    }
    assert!(schema.is_valid(&json(STEEL)));
}

#[test]
fn the_command_prints_the_schema() {
    let output = Desk::with("").call(&["schema"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(serde_json::from_str::<Value>(&text(&output.stdout)).unwrap(), schema());
}

/// `PLM_IMPACT_PAGES=write` writes the tables anew; read them then.
#[test]
fn the_reference_page_has_the_tables_of_the_program() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/README.md");
    let mut page = std::fs::read_to_string(path).unwrap();
    if std::env::var("PLM_IMPACT_PAGES").is_ok_and(|what| what == "write") {
        page = renewed(&page).unwrap();
        std::fs::write(path, &page).unwrap();
    }
    assert!(renewed(&page).unwrap() == page, "stale: PLM_IMPACT_PAGES=write cargo test --test command keys");
    for path in every_key().map(|key| key.path) {
        let name = path.rsplit('.').next().unwrap();
        assert!(page.contains(&format!("`{name}`")) || page.contains(&format!("`[{path}]`")), "{path}");
    }
}
