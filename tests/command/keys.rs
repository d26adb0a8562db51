//! The registry of keys: its schema and its reference page agree with what the program reads.

use plm_impact::report::reference::renewed;
use plm_impact::scenario::schema::schema;

use std::collections::{BTreeMap, BTreeSet};

use plm_impact::plan::Source;
use plm_impact::scene::KEYS;
use plm_impact::scene::key::Form;

use crate::common::prelude::*;

#[test]
fn the_command_prints_the_schema() {
    let output = Desk::with("").call(&["schema"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(serde_json::from_str::<Value>(&text(&output.stdout)).unwrap(), schema());
}

/// `PLM_IMPACT_PAGES=write` writes the tables anew; read them then.
#[test]
fn the_reference_pages_have_the_tables_of_the_program() {
    let mut tables = 0;
    for name in ["keys.md", "results.md"] {
        let path = format!("{}/scenarios/{name}", env!("CARGO_MANIFEST_DIR"));
        let page = std::fs::read_to_string(&path).unwrap();
        let (fresh, count) = renewed(&page);
        tables += count;
        if std::env::var("PLM_IMPACT_PAGES").is_ok_and(|what| what == "write") {
            std::fs::write(&path, &fresh).unwrap();
        } else {
            assert!(fresh == page, "{name} is stale: PLM_IMPACT_PAGES=write cargo test --test command keys");
        }
    }
    assert_eq!(tables, 3);
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/keys.md")).unwrap();
    for path in EVERY_KEY.iter().map(|key| key.path) {
        let name = path.rsplit('.').next().unwrap();
        assert!(page.contains(&format!("`{name}`")) || page.contains(&format!("`[{path}]`")), "{path}");
    }
}

/// What a key is part of says what a table computes anew for it, and is not forgotten for any key.
#[test]
fn a_key_that_keeps_contact_or_law_says_so() {
    let text = format!("{STEEL}[friction]\ncoefficient = 0.1\n[gravity]\nacceleration = 9.81\n");
    let scene = Scenario::from_text("s.toml", &text, &[]).unwrap().resolve().unwrap();
    let contact = |input: &Input| format!("{:?}", input.resolve().contact());
    let (own, law) = (contact(&scene.input), scene.input.hardening_law());
    let mut kept = 0;
    for key in KEYS.iter() {
        let (low, high) = key.quantity.range();
        let mut changed = scene.input.clone();
        key.put(&mut changed, if high.is_finite() { 0.3 * low.max(0.0) + 0.7 * high } else { low.max(0.0) + 1.0 });
        assert!(key.part.changes_contact() || contact(&changed) == own, "{}", key.path);
        assert!(key.part.changes_law() || changed.hardening_law() == law, "{}", key.path);
        kept += u32::from(!key.part.changes_contact());
    }
    assert!(kept >= 6, "{kept}");
}

#[test]
fn every_file_that_a_key_names_is_in_the_hash() {
    let mut hashes = BTreeSet::from([Source::default().sha256()]);
    let named: Vec<&str> =
        EVERY_KEY.iter().filter(|key| matches!(key.form, Form::File(_))).map(|key| key.path).collect();
    for path in &named {
        let files = BTreeMap::from([((*path).to_owned(), "x".to_owned())]);
        hashes.insert(Source { files, ..Source::default() }.sha256());
    }
    assert_eq!(hashes.len(), named.len() + 1);
}
