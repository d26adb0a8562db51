//! The tables of the reference pages (`scenarios/keys.md`, `results.md`, `units.md`): every key, every
//! result, every material, every unit, as Markdown.

use std::fmt::Write as _;

use plm_impact::report::text::{calibrate, check, indentation, materials, sweep, testers, units};
use plm_impact::results::series;
use plm_impact::results::{NumberFormat, ResultSpec, impact, pulse, trace};
use plm_impact::scenario::key_docs::form_as_markdown;
use plm_impact::scenario::keys::key_spec::KeySpec;
use plm_impact::strings::markdown_table;

use crate::common::prelude::*;

/// A part of a page: its name, and its text.
type Part = (&'static str, fn() -> String);

const PARTS: [Part; 5] = [
    ("keys", keys),
    ("results", of_results),
    ("materials", of_materials),
    ("units", units_table),
    ("testers", testers_table),
];

/// A page in which every table between two marks is written anew, and the number of these tables. The marks are comments such as
/// `<!-- keys: form_as_markdown by a test -->`.
pub fn renewed(page: &str) -> (String, usize) {
    let mut count = 0;
    let write = |page: String, (name, text): &Part| {
        let begin = format!("<!-- {name}: written by a test -->");
        let end = format!("<!-- end of {name} -->");
        let parts = page.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?.1)));
        let Some((before, after)) = parts else { return page };
        count += 1;
        format!("{before}{begin}\n\n{}{end}{after}", text())
    };
    (PARTS.iter().fold(page.to_owned(), write), count)
}

fn units_table() -> String {
    markdown_table(&units::unit_rows()) + "\n"
}

fn testers_table() -> String {
    markdown_table(&testers::tester_rows()) + "\n"
}

fn of_materials() -> String {
    markdown_table(&materials::material_rows("")) + "\n"
}

/// The results of a file, or of a part of one, and their names with how each is shown.
type FileOfResults = (String, Vec<(&'static str, NumberFormat)>);

fn file<T>(title: &str, results: &[ResultSpec<T>]) -> FileOfResults {
    let mut text = format!("### {title}\n\n| name | meaning | reported if |\n|---|---|---|\n");
    for ResultSpec { name, description: about, condition, column, .. } in results {
        let mark = if column.is_some() { " \u{25a6}" } else { "" };
        let condition = if condition.is_empty() { "always" } else { condition };
        let _ = writeln!(text, "| `{name}`{mark} | {about} | {condition} |");
    }
    (text + "\n", results.iter().map(|result| (result.name, result.format)).collect())
}

/// The files of results of every kind of scene.
fn files() -> [FileOfResults; 16] {
    [
        file("One impact: `summary.json`, and columns of tables (\u{25a6})", &impact::impact_results()),
        file("One impact: `trace.csv`", &trace::trace_results()),
        file("One impact: `pulse.csv`", &pulse::pulse_results()),
        file("One impact: `spectrum.csv`", &pulse::spectrum_results()),
        file("Repeated impacts: `summary.json`", &series::series_results()),
        file("Repeated impacts: `impacts.csv`", &series::impact_columns()),
        file("Repeated impacts: `trace.csv`", &series::trace_columns()),
        file("Indentation: every half-space in `summary.json`", &indentation::half_space_results()),
        file("Indentation: every step of a half-space", &indentation::step_results()),
        file("Indentation: `trace.csv`", &indentation::trace_columns()),
        file("Tables: `summary.json`", &sweep::total_results()),
        file("Tables: every other named column in `summary.json`", &sweep::distributions()),
        file("Tables: every random key in `summary.json`", &sweep::random_key_results()),
        file("Calibrations: `summary.json`", &calibrate::calibration_results()),
        file("Calibrations: every key in `summary.json`", &calibrate::key_results()),
        file("Checks: `contact` in `check --json`", &check::contact_results()),
    ]
}

fn of_results() -> String {
    files().into_iter().map(|(markdown, _)| markdown).collect()
}

#[test]
fn names_end_in_unit_of_their_number() {
    let all: Vec<_> = files().into_iter().flat_map(|(_, names)| names).collect();
    assert!(all.len() > 200, "{}", all.len());
    let unit_of = |shown| if let NumberFormat::Unit(dimension) = shown { Some(dimension) } else { None };
    let units: Vec<_> = all.iter().filter_map(|(_, shown)| unit_of(*shown)).collect();
    for (name, shown) in all {
        // the longest end that is a unit: "_m_per_s" ends in "_s" too
        let ends = units.iter().filter(|unit| name.ends_with(unit.suffix()));
        let unit = ends.max_by_key(|unit| unit.suffix().len());
        assert_eq!(unit_of(shown).as_ref(), unit, "{name}");
    }
}

/// All keys, a table for every table of a scenario: first those that a user sets, then those for experts.
fn keys() -> String {
    let mut tables: Vec<&str> = Vec::new();
    for (table, _) in ALL_KEYS.iter().map(place) {
        if !tables.contains(&table) {
            tables.push(table);
        }
    }
    // the tables in the order of the registry, those of the laws together
    tables.sort_by_key(|table| ALL_KEYS.iter().position(|key| key.path.split('.').next() == table.split('.').next()));
    let (of_experts, usual): (Vec<&str>, Vec<&str>) = tables.into_iter().partition(|table| is_of_experts(table));
    let [usual, of_experts] = [usual, of_experts].map(|tables| tables.into_iter().map(table).collect::<String>());
    usual + EXPERTS + &of_experts
}

const EXPERTS: &str = "## Keys for experts

The constants of the other laws, and the integration. These keys are rarely needed: the defaults are the constants of the papers, and a
relative tolerance of 1e-10.

";

/// The constants of laws other than the default one, and the solver.
fn is_of_experts(table: &str) -> bool {
    table == "solver" || table.starts_with("law.") && table != "law.plm"
}

fn table(name: &str) -> String {
    let mut text = format!("### {}\n\n| key | value | default | meaning |\n|---|---|---|---|\n", heading(name));
    for key in ALL_KEYS.iter().filter(|key| place(key).0 == name) {
        let axis = if NumericKey::find(key.path).is_some() { " \u{2195}" } else { "" };
        let default = if key.default.is_empty() { "\u{2013}" } else { key.default };
        let _ = writeln!(
            text,
            "| `{}`{axis} | {} | {default} | {} |",
            place(key).1,
            form_as_markdown(&key.form),
            key.description
        );
    }
    text + "\n"
}

/// The table that a key stands in, and its name there; `sweep` and `monte_carlo` are tables themselves.
fn place(key: &KeySpec) -> (&'static str, &'static str) {
    key.path.rsplit_once('.').unwrap_or((key.path, key.path))
}

fn heading(table: &str) -> String {
    let name = match table.strip_suffix("[]") {
        Some(list) => format!("`[[{list}]]`"),
        None => format!("`[{table}]`"),
    };
    let law = table.strip_prefix("law.").and_then(LawChoice::from_name);
    law.map_or(name.clone(), |law| format!("{name}: {}", law.info().title))
}
