//! The report of `validate`: every comparison as CSV, and a summary for the terminal and for a page in Markdown.

use std::fmt::Write as _;

use super::check::{Check, Verdict, count, largest, mean, rms};
use super::laws::OfLaw;
use crate::units::aligned::{aligned, markdown};

/// The text of `validation.csv`, with a row for every check. Deviations and tolerances are shares, not per cent.
pub fn csv(checks: &[Check]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let columns = "quantity,case,reference,unit,expected,got,deviation,tolerance,tolerance_source,verdict";
    writer.write_record(columns.split(','))?;
    for check in checks {
        let number = |i: usize| check.numbers.map_or_else(String::new, |numbers| numbers[i].to_string());
        let unit = check.numbers.map_or("", |_| check.group.unit);
        writer.write_record([
            &check.quantity(),
            &check.case,
            check.group.reference,
            unit,
            &number(0),
            &number(1),
            &check.deviation.to_string(),
            &check.tolerance.limit.to_string(),
            &check.tolerance.source(),
            check.verdict().name(),
        ])?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

/// The checks of each quantity, with those of its statistics.
fn groups(checks: &[Check]) -> impl Iterator<Item = &[Check]> {
    checks.chunk_by(|a, b| a.group.quantity == b.group.quantity)
}

/// A share in per cent; below 1e-4 as a plain number.
pub(super) fn share(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude == 0.0 {
        "0".to_owned()
    } else if magnitude < 1e-4 {
        format!("{value:.0e}").replace('-', "−")
    } else {
        format!("{:.2} %", 100.0 * value).replace('-', "−")
    }
}

/// A share as [`share`] writes it, with a plus sign if it is positive.
pub(super) fn signed(value: f64) -> String {
    if value > 0.0 { format!("+{}", share(value)) } else { share(value) }
}

/// The line that summarises all checks.
fn verdict(checks: &[Check]) -> String {
    let known = match count(checks, Verdict::Known) {
        0 => String::new(),
        known => format!(", {known} beyond it as is known of the built-in law"),
    };
    match count(checks, Verdict::Miss) {
        0 => format!("{} checks, {} within their tolerance{known}", checks.len(), count(checks, Verdict::Pass)),
        missed => format!("{missed} of {} checks MISSED their tolerance{known}", checks.len()),
    }
}

/// The names of the columns, and a row for each quantity.
fn summary(checks: &[Check]) -> Vec<[String; 7]> {
    let row = |group: &[Check]| {
        let (single, overall): (Vec<&Check>, Vec<&Check>) = group.iter().partition(|check| check.statistic.is_none());
        let deviations: Vec<f64> = single.iter().map(|check| check.deviation).collect();
        let limits = || single.iter().map(|check| check.tolerance.limit);
        let (low, high) = (limits().fold(f64::INFINITY, f64::min), limits().fold(0.0, f64::max));
        let limit = if high / low > 1.005 { format!("{} to {}", share(low), share(high)) } else { share(high) };
        let of_statistic = |check: &&Check| format!(", {} {}", check.statistic?, share(check.tolerance.limit)).into();
        let overall: Vec<String> = overall.iter().filter_map(of_statistic).collect();
        let verdict = match (count(group, Verdict::Miss), count(group, Verdict::Known)) {
            (0, 0) => Verdict::Pass.name().to_owned(),
            (0, known) => format!("{}: {known}", Verdict::Known.name()),
            (missed, _) => format!("{}: {missed}", Verdict::Miss.name()),
        };
        [
            group[0].group.quantity.to_owned(),
            deviations.len().to_string(),
            signed(mean(&deviations)),
            share(rms(&deviations)),
            signed(largest(deviations)),
            limit + &overall.concat(),
            verdict,
        ]
    };
    let names = ["quantity", "checks", "mean", "rms", "largest", "tolerance", "verdict"].map(str::to_owned);
    std::iter::once(names).chain(groups(checks).map(row)).collect()
}

/// The remarks on known deviations, with their quantities.
fn remarks(checks: &[Check]) -> impl Iterator<Item = String> {
    let known = |group: &[Check]| {
        let check = group.iter().find(|check| check.verdict() == Verdict::Known)?;
        Some(format!("known of the built-in law: {}: {}", check.group.quantity, check.known?.remark))
    };
    groups(checks).filter_map(known)
}

/// The summary, the misses and the known deviations, for the terminal.
pub fn table(checks: &[Check]) -> String {
    let mut text = aligned(&summary(checks), |column| column == 0 || column == 6);
    for check in checks.iter().filter(|check| check.verdict() == Verdict::Miss) {
        let Check { case, tolerance, deviation, .. } = check;
        let (off, limit, source) = (signed(*deviation), share(tolerance.limit), tolerance.source());
        let _ = writeln!(text, "MISS: {}: {case}: {off}, tolerance {limit} ({source})", check.quantity());
    }
    for remark in remarks(checks) {
        let _ = writeln!(text, "{remark}");
    }
    text + &verdict(checks) + "\n"
}

/// The names of the columns, and a row for every law.
fn of_laws(laws: &[OfLaw]) -> Vec<[String; 6]> {
    let row = |OfLaw { name, impacts, rms: [restitution, force, dent, time] }: &OfLaw| {
        [name.clone(), impacts.to_string(), share(*restitution), share(*time), share(*force), share(*dent)]
    };
    let names = ["law", "impacts", "restitution", "contact time", "peak force", "dent depth"].map(str::to_owned);
    std::iter::once(names).chain(laws.iter().map(row)).collect()
}

/// The page of the report: the table of laws, and a table of all comparisons with every reference. For the built-in law it
/// also says where the law deviates, and shows the pictures.
pub fn page(checks: &[Check], laws: &[OfLaw], law: &str, is_built_in: bool) -> String {
    let mut tables = String::new();
    let rows = summary(checks);
    let mut next = 1;
    for of_reference in groups(checks).collect::<Vec<_>>().chunk_by(|a, b| a[0].group.reference == b[0].group.reference)
    {
        let end = next + of_reference.len();
        let table: Vec<_> = rows[..1].iter().chain(&rows[next..end]).cloned().collect();
        next = end;
        let _ =
            writeln!(tables, "\n### Against {}\n\n{}", of_reference[0][0].group.reference, markdown(&table).trim_end());
    }
    for remark in remarks(checks) {
        let _ = writeln!(tables, "\n{remark}.");
    }
    let about = if is_built_in { include_str!("built_in_law.md") } else { "" };
    let (verdict, laws) = (verdict(checks), markdown(&of_laws(laws)));
    format!(include_str!("page.md"), law = law, verdict = verdict, laws = laws, tables = tables, about = about)
}
