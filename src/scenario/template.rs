//! Scenarios to start from, for `plm-impact init`. Their comments are the sentences of the registry of keys.

use std::fmt::Write as _;

use super::Kind;
use super::file::{every_key, list_of};
use crate::scene::key::{AnyKey, Form};
use crate::scene::keys::varied;

/// Characters of a line of comment.
const WIDTH: usize = 110;

/// Two bodies.
const BODIES: &str = r#"
[sphere]
radius = "5 mm"
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"

[half_space]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_strength = "345 MPa"
"#;

/// A sentence about a kind, and its tables after those of the bodies. A line that begins with `#` is optional.
fn parts(kind: Kind) -> [&'static str; 2] {
    match kind {
        Kind::Impact => [
            "One impact.",
            r#"
[impact]
speed = "3 m/s"

#[gravity]
#acceleration = "9.81 m/s^2"

#[law.plm]
#unloading_exponent = "pressure-shape"

#[output]
#samples = 1000
"#,
        ],
        Kind::Sweep => [
            "A table of impacts: all combinations of the values of its axes.",
            r#"
[sweep]
"impact.speed" = { logspace = ["1 mm/s", "10 m/s"], points = 61 }
"half_space.yield_strength" = ["200 MPa", "345 MPa", "550 MPa"]

#[output]
#columns = ["contact_time_s", "peak_force_N"]
"#,
        ],
        Kind::MonteCarlo => [
            "A table of impacts with random values: how far the restitution is spread.",
            r#"
[monte_carlo]
samples = 10000
seed = 7
"half_space.yield_strength" = { normal = { mean = "345 MPa", sd = "20 MPa" } }
"impact.speed" = { uniform = ["2.5 m/s", "3.5 m/s"] }

#[output]
#columns = ["contact_time_s", "peak_force_N"]
"#,
        ],
        Kind::Repeat => [
            "A sphere that bounces: impacts one after the other.",
            r#"
[impact]
drop_height = "0.5 m"

[gravity]
acceleration = "9.81 m/s^2"

[repeat]
spot = "fresh"
impacts = 8
#until.speed = "1 cm/s"

#[output]
#samples = 100
"#,
        ],
        Kind::Indentation => [
            "A slow indentation: loads and indentations one after the other.",
            r#"
[indentation]
steps = [{ load = "100 N" }, { load = "10 N" }, { indentation = "10 um" }, { load = "0 N" }]

#[output]
#samples = 1000
"#,
        ],
        Kind::Compare => [
            "A comparison: the unloading of several laws from one peak.",
            r#"
[compare]
peak_indentation_ratio = 105.1
#laws = ["plm", "thornton", "stronge"]
"#,
        ],
        Kind::Calibrate => [
            "A calibration: the yield strength that a measured rebound needs.",
            r#"
[impact]
speed = "3 m/s"

[calibrate]
free."half_space.yield_strength" = { from = "100 MPa", to = "3 GPa" }
measured.restitution = 0.49
noise.restitution = 0.01
#robust = "student-t"
"#,
        ],
    }
}

/// A scenario of this kind, with a comment for every key.
pub fn template(kind: Kind) -> String {
    let [about, tables] = parts(kind);
    let name = Kind::ALL.iter().find(|(_, other)| *other == kind).map_or("", |(name, _)| name);
    let mut text = format!(
        "# {about} This file runs as it is: plm-impact run {name}.toml\n# A number without a unit is in SI. A # before a key, or a table, leaves it out.\n"
    );
    let mut table = String::new();
    // nothing moves there
    let has_mass = !matches!(kind, Kind::Indentation | Kind::Compare);
    let bodies = BODIES.lines().filter(|line| has_mass || !line.starts_with("density"));
    for line in bodies.chain(tables.lines()) {
        let (mark, line) = line.strip_prefix('#').map_or(("", line), |line| ("#", line));
        let path = match line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
            Some(name) => {
                name.clone_into(&mut table);
                table.clone()
            }
            None => format!("{table}.{}", line.split(" = ").next().unwrap_or_default().replace('"', "")),
        };
        let told = if line.is_empty() { None } else { told(&path, !mark.is_empty()) };
        if let Some(told) = told {
            comment(&mut text, &told);
        }
        let _ = writeln!(text, "{mark}{line}");
    }
    text
}

/// The sentences of the registry about a key.
fn told(path: &str, is_left_out: bool) -> Option<String> {
    let path = if path.starts_with("calibrate.free.") { "calibrate.free" } else { varied(path) };
    let Some(AnyKey { about, default, form, .. }) = every_key().find(|key| key.path == path) else {
        return list_of(path).map(|list| format!("A list; every item is {}.", list.item));
    };
    let words = match form {
        Form::Word(words) | Form::WordList(words) => format!(" There are: {}.", (words.known)().join(", ")),
        _ => String::new(),
    };
    let default = if is_left_out && !default.is_empty() { format!(" Without it: {default}.") } else { String::new() };
    Some(format!("{about}{words}{default}"))
}

/// A text in lines that begin with `#`.
fn comment(text: &mut String, told: &str) {
    let mut line = "#".to_owned();
    for word in told.split(' ') {
        if line.len() + 1 + word.len() > WIDTH {
            let _ = writeln!(text, "{line}");
            "#".clone_into(&mut line);
        }
        line.push(' ');
        line.push_str(word);
    }
    let _ = writeln!(text, "{line}");
}
