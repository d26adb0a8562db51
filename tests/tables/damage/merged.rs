//! Damaged shards and edited sidecars.

use std::fs;

use proptest::prelude::*;
use serde_json::Value;

use super::{SHARDS, TABLES, copy, done, is_refused, merge, name};

/// A damage of a shard. Places are shares of its length or of its rows.
#[derive(Debug, Clone)]
enum Damage {
    /// The first digit after this place is increased by one.
    Digit(f64),
    /// A field of a row is replaced by a word.
    Field(f64, usize, &'static str),
    /// The file is cut off at this place.
    Cut(f64),
    /// A text is appended.
    Appended(&'static str),
    /// This number of bytes are set to NUL, as after a crash.
    Hole(f64, usize),
    /// Two rows are exchanged.
    Swapped(f64, f64),
    /// A column is removed from every row.
    Column(usize),
    /// The rows are those of another scenario, with the same columns and cases.
    Foreign,
}

fn damage() -> impl Strategy<Value = Damage> {
    let share = || 0.0..1.0;
    let word = prop::sample::select(vec!["zz", "1e99", "", "NaN", "0.5"]);
    prop_oneof![
        share().prop_map(Damage::Digit),
        (share(), 0..12usize, word).prop_map(|(row, field, word)| Damage::Field(row, field, word)),
        share().prop_map(Damage::Cut),
        prop::sample::select(vec!["\n", "0", "]\n", "\0"]).prop_map(Damage::Appended),
        (share(), 1..5000usize).prop_map(|(at, length)| Damage::Hole(at, length)),
        (share(), share()).prop_map(|(one, other)| Damage::Swapped(one, other)),
        (0..12usize).prop_map(Damage::Column),
        Just(Damage::Foreign),
    ]
}

#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn place(share: f64, length: usize) -> usize {
    (share * length as f64) as usize
}

/// The row with a field replaced, or removed.
fn with_field(row: &str, field: usize, word: Option<&str>) -> String {
    let mut fields: Vec<&str> = row.split(',').collect();
    let field = field % fields.len();
    match word {
        Some(word) => fields[field] = word,
        None => drop(fields.remove(field)),
    }
    fields.join(",")
}

fn damaged(bytes: &[u8], foreign: &[u8], damage: &Damage) -> Vec<u8> {
    let text = String::from_utf8(bytes.to_vec()).unwrap();
    let rows: Vec<String> = text.split_inclusive('\n').map(str::to_owned).collect();
    match damage {
        Damage::Digit(at) => {
            let mut bytes = bytes.to_vec();
            let from = place(*at, bytes.len());
            if let Some(digit) = bytes[from..].iter_mut().find(|byte| byte.is_ascii_digit()) {
                *digit = if *digit == b'9' { b'0' } else { *digit + 1 };
            }
            bytes
        }
        Damage::Field(at, field, word) => {
            let (mut rows, row) = (rows, place(*at, text.lines().count()));
            rows[row] = with_field(rows[row].trim_end(), *field, Some(word)) + "\n";
            rows.concat().into_bytes()
        }
        Damage::Cut(at) => bytes[..place(*at, bytes.len())].to_vec(),
        Damage::Appended(more) => [bytes, more.as_bytes()].concat(),
        Damage::Hole(at, length) => {
            let mut bytes = bytes.to_vec();
            let from = place(*at, bytes.len());
            bytes[from..].iter_mut().take(*length).for_each(|byte| *byte = 0);
            bytes
        }
        Damage::Swapped(one, other) => {
            let mut rows = rows;
            let (one, other) = (place(*one, rows.len()), place(*other, rows.len()));
            rows.swap(one, other);
            rows.concat().into_bytes()
        }
        Damage::Column(field) => {
            let rows = rows.iter().map(|row| with_field(row.trim_end(), *field, None) + "\n");
            rows.collect::<String>().into_bytes()
        }
        Damage::Foreign => foreign.to_vec(),
    }
}

proptest! {
    #![proptest_config(crate::common::cases(150))]

    #[test]
    fn a_damaged_shard_is_never_merged(
        damage in damage(),
        shard in 0..SHARDS,
        format in prop::sample::select(vec!["csv", "json"]),
    ) {
        let (shards, name) = (copy(format), name(shard, format));
        let path = shards.path().join(&name);
        let (bytes, foreign) = (fs::read(&path).unwrap(), fs::read(TABLES.others.join(format).join(&name)).unwrap());
        let changed = damaged(&bytes, &foreign, &damage);
        prop_assume!(changed != bytes);
        fs::write(&path, changed).unwrap();
        is_refused(shards.path(), &name);
    }
}

#[test]
fn shards_as_they_were_written_are_merged() {
    for format in ["csv", "json"] {
        let out = tempfile::tempdir().unwrap();
        done(&merge(copy(format).path(), &out.path().join("table")));
    }
}

#[test]
fn an_edited_sidecar_is_never_merged() {
    // values that somebody may write into the sidecar
    let values = ["0", "1", "7", "-1", "1e300", "1000000000", "null", "\"x\"", "\"json\"", "{}", "[]"];
    let values: Vec<Value> = values.iter().map(|text| serde_json::from_str(text).unwrap()).collect();
    let (format, shard) = ("csv", 1);
    let shards = copy(format);
    let path = shards.path().join(format!("{}.sidecar.json", name(shard, format)));
    let text = fs::read_to_string(&path).unwrap();
    let sidecar: serde_json::Map<String, Value> = serde_json::from_str(&text).unwrap();
    let refused = |edited: &serde_json::Map<String, Value>| {
        if *edited != sidecar {
            fs::write(&path, serde_json::to_vec(edited).unwrap()).unwrap();
            is_refused(shards.path(), &name(shard, format));
        }
    };
    let more = ["block", "cases", "rows"].map(str::to_owned);
    for key in sidecar.keys().cloned().chain(more) {
        for value in &values {
            let mut edited = sidecar.clone();
            edited.insert(key.clone(), value.clone());
            refused(&edited);
        }
        let mut without = sidecar.clone();
        without.remove(&key);
        refused(&without);
        // also inside an entry
        for inner in sidecar.get(&key).and_then(Value::as_object).iter().flat_map(|entry| entry.keys()) {
            for value in &values {
                let mut edited = sidecar.clone();
                edited[&key][inner] = value.clone();
                refused(&edited);
            }
        }
    }
    for torn in ["", "{", &text[..text.len() / 2], "null", "[]"] {
        fs::write(&path, torn).unwrap();
        is_refused(shards.path(), &name(shard, format));
    }
}

#[test]
fn all_sidecars_with_fewer_shards_or_cases_give_no_short_table() {
    let shards = copy("csv");
    let edit = |from: &str, to: &str| {
        for shard in 0..SHARDS {
            let path = shards.path().join(format!("{}.sidecar.json", name(shard, "csv")));
            let text = fs::read_to_string(&path).unwrap();
            fs::write(&path, text.replace(from, to)).unwrap();
        }
    };
    edit("\"shards\": 3", "\"shards\": 2");
    is_refused(shards.path(), "table-2-of-3.csv");
    let third = ["", ".sidecar.json"].map(|suffix| shards.path().join(name(2, "csv") + suffix));
    let away = third.clone().map(|path| (fs::read(&path).unwrap(), fs::remove_file(path).unwrap()).0);
    // two shards whose sidecars say that there are two; then the blocks would have 2 cases, not 1
    is_refused(shards.path(), "table-0-of-3.csv");
    third.iter().zip(away).for_each(|(path, bytes)| fs::write(path, bytes).unwrap());
    edit("\"shards\": 2", "\"shards\": 3");
    edit("points = 40", "points = 30");
    is_refused(shards.path(), "table-0-of-3.csv");
}
