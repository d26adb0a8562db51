//! The law of a contact as a C header without dependencies, its vectors, and a program that proves a build of the header with them.

mod vectors;

use std::fmt::Write as _;

use crate::error::{Error, ErrorKind};
use crate::files::{OutputFile, VERSION};
use crate::impact::Contact;
use crate::impact::dem::law_table::{LawTable, N_QUANTITIES};
use crate::numerics::piecewise_fit::{FittedInterval, N_TERMS};
use crate::report::run::contact_at_scenario_speed;
use crate::scenario::Scenario;
use crate::scenario::input::Input;
use crate::units::{Dimension, format_input};

const HEADER: &str = include_str!("law.h");
const TEST_PROGRAM: &str = include_str!("test.c");

/// The fields of a metal that relaxes at maximum compression: the largest force and the elastic approach of its branches.
const RELAXED_FIELDS: &str = "
    PLM_REAL branch_peak[PLM_{NAME}_TERMS];
    PLM_REAL branch_approach[PLM_{NAME}_TERMS];";
const RELAXED_BRANCH: &str = "
        /* at maximum compression the metal relaxes, and the force drops */
        branch.peak = plm_{name}_value(at->branch_peak, t) * PLM_{NAME}_FORCE;
        branch.approach = plm_{name}_value(at->branch_approach, t) * PLM_{NAME}_LENGTH;";
const RELAXED_LOADING: &str = "
    if (memory->peak_indentation > plm_{name}_start(0) * PLM_{NAME}_LENGTH) {
        /* a relaxed metal follows its branch until the branch meets the loading curve */
        const plm_{name}_branch branch = plm_{name}_unload(memory);
        const PLM_REAL recovered = (indentation - memory->peak_indentation) + branch.approach;
        const PLM_REAL continued = branch.peak * PLM_POW(recovered / branch.approach, branch.exponent);
        if (continued < force) {
            return continued;
        }
    }";

/// Header, vectors and test program of the law of a scenario. The names of files and functions contain `name`, and `command` is the
/// origin that the header names. A strength that depends on the strain rate is that of the speed of the scenario.
///
/// # Errors
/// [`Error`] for a bad scenario, one with forces that a header has not, or a law that is no table of polynomials.
pub fn header_files(scenario: &Scenario, name: &str, command: &str) -> Result<Vec<OutputFile>, Error> {
    let (input, contact) = contact_at_scenario_speed(scenario)?;
    let table = contact.law_table().map_err(|reason| {
        let law = input.law().name();
        let advice = "Choose another law, or use the C functions (plots/lammps/README.md)";
        let message = format!("--to header: the law {law} cannot be a header, because {reason}. {advice}.");
        Error::for_file(ErrorKind::Input, scenario.document.name(), message)
    })?;
    let name = identifier(name);
    let origin = [
        ("{title}", format!("plm_{name}.h: the force of one contact, as a header without dependencies")),
        ("{version}", VERSION.to_owned()),
        ("{command}", comment_text(command)),
        ("{scenario}", comment_text(scenario.document.name())),
        ("{sha256}", scenario.sha256()),
        ("{law}", law_text(&input, &contact)),
        ("{pair}", pair_text(&input, &contact)),
    ];
    let file = |end: &str, text: String| OutputFile { name: format!("plm_{name}{end}"), bytes: text.into_bytes() };
    let header = fill(HEADER, &origin.into_iter().chain(numbers(&contact, &table)).collect::<Vec<_>>());
    Ok(vec![
        file(".h", with_name(&header, &name)),
        file("_vectors.csv", vectors::vectors_csv(&contact, &name)),
        file("_test.c", with_name(TEST_PROGRAM, &name)),
    ])
}

/// A text as a part of names in C. `contact` and `impact` are in names of the C functions, whose header is `plm_impact.h`.
fn identifier(text: &str) -> String {
    let lower = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    match text.chars().map(lower).collect::<String>() {
        name if ["", "contact", "impact"].contains(&name.as_str()) => name + "_law",
        name => name,
    }
}

/// A text that cannot end a comment of C.
fn comment_text(text: &str) -> String {
    text.replace("*/", "* /").replace(['\n', '\r'], " ")
}

fn fill(template: &str, values: &[(&str, String)]) -> String {
    values.iter().fold(template.to_owned(), |text, (place, value)| text.replace(place, value))
}

fn with_name(text: &str, name: &str) -> String {
    text.replace("{name}", name).replace("{NAME}", &name.to_ascii_uppercase())
}

/// The law, and the rate that its strength belongs to.
fn law_text(input: &Input, contact: &Contact) -> String {
    let law = input.law();
    let rate = contact.strain_rate_result().map_or_else(String::new, |rated| {
        format!(
            "; strength at {:.4e} 1/s: {:.4} times the strength of the slow test, at maximum compression {:.4} times",
            rated.strain_rate, rated.factor, rated.factor_at_peak
        )
    });
    comment_text(&format!("{} ({}){rate}", law.name(), law.source()))
}

/// The bodies.
fn pair_text(input: &Input, contact: &Contact) -> String {
    let length = |value| format_input(value, Dimension::Length);
    let sphere = format!("sphere of radius {}", length(contact.sphere().radius));
    let target = match contact.half_space().radius {
        Some(radius) => format!("body of radius {}", length(radius)),
        None => "half-space".to_owned(),
    };
    let key_values = input.key_values();
    let of_bodies =
        key_values.iter().filter(|one| ["sphere.", "half_space."].iter().any(|body| one.path.starts_with(body)));
    let keys = of_bodies.fold(String::new(), |text, one| {
        text + "\n *   " + &comment_text(&format!("{} = {}", one.path, one.terminal_text()))
    });
    format!("{sphere} on a {target}{keys}")
}

/// A number in C, with all its digits.
fn number(value: f64) -> String {
    match value {
        f64::INFINITY => "HUGE_VAL".to_owned(),
        value => format!("{value:e}"),
    }
}

fn list(values: &[f64]) -> String {
    values.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")
}

/// The numbers of the law.
fn numbers(contact: &Contact, table: &LawTable) -> Vec<(&'static str, String)> {
    let validated = contact.validated_indentation();
    let LawTable { intervals, relaxes, .. } = table;
    let end = intervals.last().map_or(f64::INFINITY, |last| last.end);
    let starts = intervals.iter().map(|interval| interval.start).chain([end]);
    let meters =
        |value: f64| if value.is_finite() { format_input(value, Dimension::Length) } else { "any size".to_owned() };
    let n_used = if *relaxes { N_QUANTITIES } else { 4 };
    let rows = |intervals: &[FittedInterval<N_QUANTITIES>]| {
        intervals.iter().fold(String::new(), |mut text, interval| {
            let _ = writeln!(text, "        {{{}, {},", number(interval.middle), number(interval.inverse_half));
            let terms: Vec<String> =
                interval.terms[..n_used].iter().map(|terms| format!("         {{{}}}", list(terms))).collect();
            let _ = writeln!(text, "{}}},", terms.join(",\n"));
            text
        })
    };
    let empty =
        FittedInterval { start: 0.0, end: 0.0, middle: 0.0, inverse_half: 0.0, terms: [[0.0; N_TERMS]; N_QUANTITIES] };
    let relaxed = |text: &str| if *relaxes { text.to_owned() } else { String::new() };
    let what_scales = if contact.half_space().radius.is_some() { "both radii at once" } else { "the radius" };
    vec![
        ("{validated}", meters(validated)),
        ("{end}", meters(end * table.length)),
        ("{radius}", number(contact.sphere().radius)),
        ("{mass}", number(contact.reduced_mass())),
        ("{validated_value}", number(validated)),
        ("{length}", number(table.length)),
        ("{force}", number(table.force)),
        ("{yields}", u8::from(table.yields).to_string()),
        ("{n_intervals}", intervals.len().to_string()),
        ("{n_terms}", N_TERMS.to_string()),
        ("{starts}", starts.fold(String::new(), |text, start| text + "        " + &number(start) + ",\n")),
        ("{table_size}", intervals.len().max(1).to_string()),
        ("{table}", if intervals.is_empty() { rows(&[empty]) } else { rows(intervals) }),
        ("{what_scales}", what_scales.to_owned()),
        ("{relaxed_fields}", relaxed(RELAXED_FIELDS)),
        ("{relaxed_branch}", relaxed(RELAXED_BRANCH)),
        ("{relaxed_loading}", relaxed(RELAXED_LOADING)),
    ]
}
