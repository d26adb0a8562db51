//! The notices of what is linked in. `UPDATE=1 cargo test --test program licences` writes them anew, from the
//! sources of the crates that cargo has loaded.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use crate::common::command::run_in;
use crate::common::golden::is_updating;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Name and version of every crate of `Cargo.lock` that command, module, library or page needs, with all features and on all
/// systems. Tools of builds are among them, those of tests are not.
fn linked() -> BTreeSet<String> {
    let manifest = toml::Value::Table(read("Cargo.toml").parse().unwrap());
    let tables = manifest["target"].as_table().unwrap().values().chain([&manifest]);
    let own: Vec<_> = tables.flat_map(|table| table["dependencies"].as_table().unwrap().keys().cloned()).collect();
    let lock: toml::Table = read("Cargo.lock").parse().unwrap();
    let field = |package: &toml::Value, name: &str| package[name].as_str().unwrap().to_owned();
    let packages: Vec<(String, String, Vec<String>)> = lock["package"]
        .as_array()
        .unwrap()
        .iter()
        .map(|package| {
            let needs = package.get("dependencies").and_then(toml::Value::as_array).into_iter().flatten();
            let needs = needs.map(|need| need.as_str().unwrap().to_owned());
            let name = field(package, "name");
            (format!("{name} {}", field(package, "version")), name, needs.collect())
        })
        .collect();
    // a version stands behind the name where there are several
    let is_named =
        |name: &str| packages.iter().filter(|(whole, own, _)| whole == name || own == name).collect::<Vec<_>>();
    let is_own = |need: &&String| own.iter().any(|own| need.split(' ').next() == Some(own));
    let program = is_named(env!("CARGO_PKG_NAME"));
    let mut open: Vec<&String> = program.into_iter().flat_map(|(_, _, needs)| needs).filter(is_own).collect();
    let mut found = BTreeSet::new();
    while let Some(name) = open.pop() {
        for (package, _, needs) in is_named(name) {
            if found.insert(package.clone()) {
                open.extend(needs);
            }
        }
    }
    found
}

/// The texts of licences and notices in a folder. Where a crate may be had under the MIT licence, its text alone.
fn texts(folder: &Path, licence: &str) -> Vec<String> {
    let is_text = |path: &PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy().to_lowercase();
        ["licen", "copying", "notice", "unlicense"].iter().any(|begin| name.starts_with(begin))
    };
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).filter(is_text).collect();
    files.retain(|path| path.is_file());
    files.sort();
    let mut texts: Vec<String> = files.into_iter().map(read).collect();
    // a link that the crate has lost is a path
    texts.retain(|text| text.contains(' '));
    let is_mit = |text: &&String| text.contains("Permission is hereby granted, free of charge");
    match texts.iter().find(is_mit) {
        Some(mit) if licence.contains("MIT") && !licence.contains(" AND ") => vec![mit.clone()],
        _ => texts,
    }
}

/// A paragraph that says whose work it is, and nothing else. The form of the Apache licence has one without a name.
fn is_copyright(paragraph: &str) -> bool {
    let begins = |line: &str| ["Copyright ", "All rights reserved"].iter().any(|begin| line.trim().starts_with(begin));
    paragraph.lines().all(begins) && !paragraph.contains("yyyy")
}

/// The licences of all that is linked in, as an SPDX expression: of a crate with a choice MIT, or else Apache-2.0. `own` is that of
/// the program and of the fonts.
fn expression<'a>(crates: impl Iterator<Item = &'a str>, own: [&'a str; 2]) -> String {
    let chosen = |part: &'a str| {
        let choices: Vec<&str> = part.trim_matches(['(', ')']).split(" OR ").flat_map(|name| name.split('/')).collect();
        let preferred = ["MIT", "Apache-2.0"].into_iter().find(|name| choices.contains(name));
        preferred.unwrap_or(choices[0])
    };
    let all: BTreeSet<&str> = crates.flat_map(|licence| licence.split(" AND ")).map(chosen).chain(own).collect();
    all.into_iter().collect::<Vec<_>>().join(" AND ")
}

/// Begins the line of `licenses.txt` with the licences as an SPDX expression.
const EXPRESSION: &str = "SPDX-License-Identifier of the program with all of them: ";

/// The whole file: each text once, with those who have it.
fn all_notices() -> String {
    let cargo = Command::new(env!("CARGO"))
        .current_dir(root())
        .args(["metadata", "--format-version", "1", "--locked", "--all-features"])
        .output()
        .unwrap();
    let metadata: Value = serde_json::from_slice(&cargo.stdout).unwrap();
    let wanted = linked();
    let mut licences = Vec::new();
    let mut groups: BTreeMap<String, (String, Vec<String>)> = BTreeMap::new();
    let mut add = |name: &str, text: &str| {
        let text = text.replace('\r', "");
        let paragraphs: Vec<&str> = text.split("\n\n").map(|paragraph| paragraph.trim_matches('\n')).collect();
        let (mut whose, mut body) = (Vec::new(), Vec::new());
        for (place, paragraph) in paragraphs.iter().enumerate().filter(|(_, paragraph)| !paragraph.trim().is_empty()) {
            // at the head of a text, or in the form at the end of the Apache licence; elsewhere it belongs to what is around it
            let is_form =
                || paragraphs.get(place + 1).is_some_and(|next| next.trim().starts_with("Licensed under the Apache"));
            let is_apart = is_copyright(paragraph) && (place < 3 || is_form());
            if is_apart { whose.push(*paragraph) } else { body.push(*paragraph) }
        }
        let words = body.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
        let whose: Vec<&str> = whose.iter().flat_map(|lines| lines.lines()).map(str::trim).collect();
        let (_, all) = groups.entry(words).or_insert_with(|| (body.join("\n\n"), Vec::new()));
        all.push([&[name], &whose[..]].concat().join("; "));
    };
    for package in metadata["packages"].as_array().unwrap() {
        let text = |key: &str| package[key].as_str().unwrap_or_default();
        let name = format!("{} {}", text("name"), text("version"));
        if !wanted.contains(&name) {
            continue;
        }
        licences.push(text("license"));
        let folder = Path::new(text("manifest_path")).parent().unwrap();
        let found = texts(folder, text("license"));
        for text in &found {
            add(&name, text);
        }
        if found.is_empty() {
            let authors: Vec<_> = package["authors"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
            let whose = if authors.is_empty() { "its authors" } else { &authors.join(", ") };
            add(&name, &format!("By {whose}, under {}; the crate has no text of it.", text("license")));
        }
        if text("name") == "dejavu" {
            let fonts = fs::read_dir(folder.join("assets")).unwrap().next().unwrap().unwrap().path();
            add("fonts DejaVu 2.37", &read(fonts.join("LICENSE")));
        }
    }
    let expression = expression(licences.into_iter(), ["MIT", "Bitstream-Vera"]);
    let mut file = format!(
        "The licences of the fonts and crates that plm-impact is linked with. Every text stands once, below the names of those\nwho have it. `UPDATE=1 cargo test --test program licences` writes this file.\n{EXPRESSION}{expression}\n"
    );
    for (text, names) in groups.values() {
        let names: String = names.iter().fold(String::new(), |all, name| all + "> " + name + "\n");
        write!(file, "\n{}\n\n{names}\n{text}\n", "=".repeat(100)).unwrap();
    }
    file
}

#[test]
fn every_linked_crate_has_a_printed_notice() {
    let path = root().join("src/interfaces/licenses.txt");
    let file = read(&path);
    if is_updating() {
        let made = all_notices();
        if made != file {
            // the command that is built already has the old ones
            return fs::write(&path, made).unwrap();
        }
    }
    let named = file.lines().filter_map(|line| line.strip_prefix("> ")?.split(';').next());
    let mut named: BTreeSet<String> = named.map(str::to_owned).collect();
    assert!(named.remove("fonts DejaVu 2.37") && file.contains("Bitstream Vera Fonts Copyright"));
    let other: Vec<_> = named.symmetric_difference(&linked()).cloned().collect();
    assert!(other.is_empty(), "{other:?}: UPDATE=1 cargo test --test program licences");
    let printed = run_in(root(), &["--licenses"]);
    assert!(printed.status.success());
    let printed = String::from_utf8(printed.stdout).unwrap();
    assert!(printed.starts_with(&read("LICENSE")) && printed.ends_with(&file));
    let none = run_in(root(), &["--error-format", "json"]);
    assert_eq!(none.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&none.stderr).contains("no command is given"));
}

#[test]
fn one_of_alternative_licences_is_chosen() {
    let licences = ["Unlicense/MIT", "(MIT OR Apache-2.0) AND Unicode-3.0", "Apache-2.0 OR BSL-1.0", "Zlib"];
    assert_eq!(
        expression(licences.into_iter(), ["MIT", "Bitstream-Vera"]),
        "Apache-2.0 AND Bitstream-Vera AND MIT AND Unicode-3.0 AND Zlib"
    );
}

/// A wheel has the fonts and the crates in it, the crate has neither.
#[test]
fn the_wheel_names_the_licences_of_what_is_linked_in() {
    let file = read("src/interfaces/licenses.txt");
    let expression = file.lines().find_map(|line| line.strip_prefix(EXPRESSION)).unwrap();
    assert!(expression.contains("Bitstream-Vera") && expression.contains("Apache-2.0"), "{expression}");
    let [python, cargo]: [toml::Table; 2] = ["pyproject.toml", "Cargo.toml"].map(|name| read(name).parse().unwrap());
    assert_eq!(python["project"]["license"].as_str(), Some(expression));
    assert_eq!(cargo["package"]["license"].as_str(), Some("MIT"));
}

/// The plug-in for LAMMPS is under the licence of LAMMPS; crate and sdist say MIT.
#[test]
fn packaged_files_have_licence_of_package() {
    let cargo = Command::new(env!("CARGO"))
        .current_dir(root())
        .args(["package", "--list", "--allow-dirty", "--offline"])
        .output()
        .unwrap();
    assert!(cargo.status.success(), "{}", String::from_utf8_lossy(&cargo.stderr));
    let list = String::from_utf8(cargo.stdout).unwrap();
    assert!(
        ["LICENSE", "src/interfaces/licenses.txt", "src/lib.rs"]
            .iter()
            .all(|name| list.lines().any(|line| line == *name))
    );
    let begin = |path: &Path| fs::read_to_string(path).unwrap_or_default().lines().take(5).collect::<String>();
    let other = |path: &&str| {
        let begin = begin(&root().join(path));
        begin.contains("SPDX-License-Identifier: GPL") || begin.contains("GNU GENERAL PUBLIC LICENSE")
    };
    assert_eq!(list.lines().filter(other).collect::<Vec<_>>(), <[&str; 0]>::default());
}
