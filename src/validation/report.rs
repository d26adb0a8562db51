//! The report of `validate`: every comparison as CSV, and a summary for the terminal and for a page in Markdown.

use std::fmt::Write as _;

use super::check::{Check, Verdict, count, largest, mean, rms};
use crate::math::power::max_or_nan;
use crate::units::aligned::aligned;

/// The text of `validation.csv`, with a row for every check. Deviations and tolerances are shares, not per cent.
pub fn csv(checks: &[Check]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "quantity",
        "case",
        "reference",
        "unit",
        "expected",
        "got",
        "deviation",
        "tolerance",
        "tolerance_source",
        "verdict",
    ])?;
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for check in checks {
        writer.write_record([
            &check.quantity,
            &check.case,
            check.reference,
            check.unit,
            &number(check.expected),
            &number(check.got),
            &check.deviation.to_string(),
            &check.tolerance.limit.to_string(),
            &check.tolerance.source(),
            check.verdict().name(),
        ])?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

/// The checks of one quantity.
struct Group<'a> {
    quantity: &'a str,
    checks: Vec<&'a Check>,
}

impl Group<'_> {
    fn deviations(&self) -> Vec<f64> {
        self.checks.iter().map(|check| check.deviation).collect()
    }

    /// "pass", or the number of checks that do not pass.
    fn verdict(&self) -> String {
        let count = |verdict| self.checks.iter().filter(|check| check.verdict() == verdict).count();
        match (count(Verdict::Miss), count(Verdict::Known)) {
            (0, 0) => Verdict::Pass.name().to_owned(),
            (0, known) => format!("{}: {known}", Verdict::Known.name()),
            (missed, _) => format!("{}: {missed}", Verdict::Miss.name()),
        }
    }

    /// The remark on known deviations, if a check has one.
    fn remark(&self) -> Option<&'static str> {
        let known = self.checks.iter().find(|check| check.verdict() == Verdict::Known);
        known.and_then(|check| check.known).map(|known| known.remark)
    }

    /// The smallest and the largest tolerance.
    fn tolerance(&self) -> String {
        let limits = || self.checks.iter().map(|check| check.tolerance.limit);
        let (low, high) = (limits().fold(f64::INFINITY, f64::min), limits().fold(0.0, max_or_nan));
        if high / low > 1.005 { format!("{} to {}", share(low), share(high)) } else { share(high) }
    }
}

/// The checks grouped by quantity, in the order in which the quantities first occur.
fn groups(checks: &[Check]) -> Vec<Group<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for check in checks {
        match groups.iter_mut().find(|group| group.quantity == check.quantity) {
            Some(group) => group.checks.push(check),
            None => groups.push(Group { quantity: &check.quantity, checks: vec![check] }),
        }
    }
    groups
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
    let mut rows = vec![["quantity", "checks", "mean", "rms", "largest", "tolerance", "verdict"].map(str::to_owned)];
    rows.extend(groups(checks).iter().map(|group| {
        let deviations = group.deviations();
        let several = |text: String| if deviations.len() > 1 { text } else { String::new() };
        [
            group.quantity.to_owned(),
            deviations.len().to_string(),
            several(signed(mean(&deviations))),
            several(share(rms(&deviations))),
            signed(largest(deviations.iter().copied())),
            group.tolerance(),
            group.verdict(),
        ]
    }));
    rows
}

/// The summary, the misses and the known deviations, for the terminal.
pub fn table(checks: &[Check]) -> String {
    let mut text = aligned(&summary(checks), |column| column == 0 || column == 6);
    for check in checks.iter().filter(|check| check.verdict() == Verdict::Miss) {
        let Check { quantity, case, tolerance, .. } = check;
        let (off, limit) = (signed(check.deviation), share(tolerance.limit));
        let _ = writeln!(text, "MISS: {quantity}: {case}: {off}, tolerance {limit} ({})", tolerance.source());
    }
    for group in groups(checks) {
        if let Some(remark) = group.remark() {
            let _ = writeln!(text, "known of the built-in law: {}: {remark}", group.quantity);
        }
    }
    text + &verdict(checks) + "\n"
}

/// The page of the report: a table for every reference. For the built-in law it also says where the law deviates, and
/// shows some of the pictures.
pub fn page(checks: &[Check], law: &str, is_built_in: bool) -> String {
    let mut tables = String::new();
    let (groups, summary) = (groups(checks), summary(checks));
    for (i, (group, row)) in groups.iter().zip(&summary[1..]).enumerate() {
        let reference = group.checks[0].reference;
        if i == 0 || groups[i - 1].checks[0].reference != reference {
            let _ = writeln!(tables, "\n## Against {reference}\n\n{HEAD}\n|---|---|---|---|---|---|---|---|");
        }
        let source = group.checks[0].tolerance.source();
        let [quantity, count, mean, rms, largest, tolerance, verdict] = row;
        let _ = writeln!(
            tables,
            "| {quantity} | {count} | {mean} | {rms} | {largest} | {tolerance} | {source} | {verdict} |"
        );
    }
    for group in &groups {
        if let Some(remark) = group.remark() {
            let _ = writeln!(tables, "\nOn record for the built-in law: {}: {remark}.", group.quantity);
        }
    }
    let about = if is_built_in { include_str!("built_in_law.md") } else { "" };
    format!(include_str!("page.md"), law = law, verdict = verdict(checks), tables = tables, about = about)
}

/// The columns of the page.
const HEAD: &str = "| quantity | checks | mean deviation | rms | largest | tolerance | from | verdict |";
