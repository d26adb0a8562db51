//! Resuming a run: unfinished rows, and finished shards.

use std::fs;

use super::{TABLES, copy, done, merge, name, names, refused, run, scenario, stderr};

#[test]
fn unfinished_rows_that_are_damaged_are_refused() {
    for format in ["csv", "json"] {
        let shards = copy(format);
        let file = scenario(shards.path(), "210 GPa");
        let table = shards.path().join(name(1, format));
        let part = shards.path().join(name(1, format) + ".part");
        let complete = fs::read_to_string(&table).unwrap();
        fs::remove_file(&table).unwrap();
        let rows: Vec<&str> = complete.split_inclusive('\n').collect();
        let row = rows[5];
        let last_field = row.rfind(',').unwrap();
        let goes_on = |damaged: &str| {
            // as after a stop with ten rows written
            let text = [&rows[..5], &[damaged], &rows[6..11]].concat().concat();
            fs::write(&part, text).unwrap();
            run(&file, shards.path(), &["--format", format, "--shard", "1/3"])
        };
        let status = row.replace("ok", "zz");
        let quoteless = row.replacen("\":", ":", 2);
        // the contact time
        let field = row.split(',').nth(4).unwrap();
        for damaged in [
            status,
            quoteless,
            row.replacen(&format!(",{field}"), "", 1),
            row.replacen(field, &format!("{field},{field}"), 1),
            row.replacen(&field[field.len() - 3..], "\0\0\0", 1),
            row.replacen(&field[field.len() - 3..], "\n", 1),
            format!("{}\n", &row[..last_field]),
            "\n".to_owned(),
            "\0".repeat(row.len()) + "\n",
        ] {
            if damaged == row {
                continue; // CSV has no quotes
            }
            let output = goes_on(&damaged);
            refused(&output, &[&name(1, format), "row 5", "delete it"]);
        }
        done(&goes_on(row));
        assert!(fs::read_to_string(&table).unwrap() == complete);
        done(&merge(shards.path(), &shards.path().join("merged")));
    }
}

#[test]
fn a_finished_shard_that_was_damaged_is_made_again() {
    let shards = copy("csv");
    let file = scenario(shards.path(), "210 GPa");
    let table = shards.path().join(name(2, "csv"));
    let again = || run(&file, shards.path(), &["--shard", "2/3"]);
    let good = fs::read(&table).unwrap();
    let written = || fs::metadata(&table).unwrap().modified().unwrap();

    // an unchanged file is kept
    let before = written();
    done(&again());
    assert_eq!(written(), before);

    // a changed digit, a missing end, and the rows of another scenario
    let mut digit = good.clone();
    let place = digit.len() - 20;
    digit[place] = if digit[place] == b'1' { b'2' } else { b'1' };
    let foreign = fs::read(TABLES.others.join("csv").join(name(2, "csv"))).unwrap();
    for damaged in [digit, good[..good.len() - 7].to_vec(), foreign] {
        assert!(damaged != good);
        fs::write(&table, &damaged).unwrap();
        done(&again());
        assert!(fs::read(&table).unwrap() == good, "{} bytes are left", damaged.len());
    }
    done(&merge(shards.path(), &shards.path().join("merged.csv")));
}

#[test]
fn a_shard_stopped_before_its_sidecar_was_completed_is_completed_without_computing_it_again() {
    let shards = copy("csv");
    let file = scenario(shards.path(), "210 GPa");
    let table = shards.path().join(name(0, "csv"));
    let sidecar = shards.path().join(name(0, "csv") + ".sidecar.json");
    let complete = fs::read_to_string(&sidecar).unwrap();
    let mut entries: serde_json::Map<String, serde_json::Value> = serde_json::from_str(&complete).unwrap();
    assert!(entries.insert("finished".to_owned(), serde_json::Value::Null).is_some());
    fs::write(&sidecar, serde_json::to_vec(&entries).unwrap()).unwrap();
    refused(
        &merge(shards.path(), &shards.path().join("merged.csv")),
        &["table-0-of-3.csv: unfinished", "run its command"],
    );
    let before = fs::metadata(&table).unwrap().modified().unwrap();
    done(&run(&file, shards.path(), &["--shard", "0/3"]));
    assert_eq!(fs::metadata(&table).unwrap().modified().unwrap(), before);
    assert_eq!(fs::read_to_string(&sidecar).unwrap(), complete);
}

#[test]
fn the_one_shard_of_an_array_of_one_is_a_shard() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), "210 GPa");
    let [whole, shards, merged] = ["whole", "shards", "merged"].map(|name| directory.path().join(name));
    done(&run(&file, &whole, &[]));
    done(&run(&file, &shards, &["--shard", "0/1"]));
    let mut found = names(&shards);
    found.sort();
    assert_eq!(found, ["table-0-of-1.csv", "table-0-of-1.csv.sidecar.json"]);
    let output = merge(&shards, &merged.join("table.csv"));
    done(&output);
    assert!(fs::read(merged.join("table.csv")).unwrap() == fs::read(whole.join("table.csv")).unwrap());
    // an undivided table in the same directory has another name
    done(&run(&file, &shards, &[]));
    let again = run(&file, &shards, &["--shard", "0/1"]);
    done(&again);
    assert!(shards.join("summary.json").exists(), "{}", stderr(&again));
}
