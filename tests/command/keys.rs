//! The registry of keys: its schema and its reference page agree with what the program reads.

use plm_impact::report::reference::renewed;
use plm_impact::scenario::schema::schema;

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
