//! Rows by a version with other table numbers are neither resumed nor merged.

use std::fs;
use std::path::Path;

use serde_json::{Map, Value};

use super::{copy, done, merge, name, refused, run, scenario};

/// Gives a sidecar the entries of another version.
fn edit(sidecar: &Path, change: impl Fn(&mut Map<String, Value>)) -> String {
    let text = fs::read_to_string(sidecar).unwrap();
    let mut entries = serde_json::from_str(&text).unwrap();
    change(&mut entries);
    fs::write(sidecar, serde_json::to_vec(&entries).unwrap()).unwrap();
    text
}

#[test]
fn rows_of_other_numbers_are_refused_and_both_versions_are_named() {
    let shards = copy("csv");
    let file = scenario(shards.path(), "210 GPa");
    let (table, sidecar) = (name(1, "csv"), name(1, "csv") + ".sidecar.json");
    let (table, sidecar) = (shards.path().join(table), shards.path().join(sidecar));
    let again = || run(&file, shards.path(), &["--shard", "1/3"]);
    let merged = shards.path().join("merged.csv");
    let text = fs::read_to_string(&sidecar).unwrap();
    let entries: Map<String, Value> = serde_json::from_str(&text).unwrap();
    let ours = format!("{} (table numbers {})", env!("CARGO_PKG_VERSION"), entries["numbers"]);

    let older = |entries: &mut Map<String, Value>| drop(entries.insert("numbers".to_owned(), Value::from(7_000)));
    // a version without such a number
    let oldest = |entries: &mut Map<String, Value>| drop(entries.remove("numbers"));
    let other = |entries: &mut Map<String, Value>| drop(entries.insert("version".to_owned(), Value::from("0.0.1")));
    #[allow(clippy::type_complexity)] // one list
    let changes: [(&dyn Fn(&mut Map<String, Value>), &str); 3] = [
        (&older, "0.1.0 (table numbers 7000)"),
        (&oldest, "0.1.0 (table numbers 0)"),
        (&other, "0.0.1 (table numbers "),
    ];
    for (change, theirs) in changes {
        let theirs = theirs.replace("0.1.0", env!("CARGO_PKG_VERSION"));
        let text = edit(&sidecar, change);
        refused(&merge(shards.path(), &merged), &["table-1-of-3.csv", &theirs, &ours, "run its command"]);
        assert!(!merged.exists());
        // a finished shard, and an unfinished one
        refused(&again(), &["table-1-of-3.csv", &theirs, &ours, "delete"]);
        let part = shards.path().join(name(1, "csv") + ".part");
        fs::rename(&table, &part).unwrap();
        refused(&again(), &["table-1-of-3.csv", &theirs, &ours, "delete"]);
        fs::rename(&part, &table).unwrap();
        fs::write(&sidecar, text).unwrap();
    }
    done(&again());
    done(&merge(shards.path(), &merged));
}
