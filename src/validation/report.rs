//! The rows as CSV, as Markdown, and summed up for the terminal.

use std::fmt::Write as _;

use super::check::{Check, Verdict, count, largest, mean, rms};
use crate::math::power::max_or_nan;

/// `validation.csv`: every row; deviations and tolerances are shares.
///
/// # Errors
/// What the CSV writer reports.
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
            check.tolerance.source,
            check.verdict().name(),
        ])?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

/// Rows of one quantity.
struct Group<'a> {
    quantity: &'a str,
    checks: Vec<&'a Check>,
}

impl Group<'_> {
    fn deviations(&self) -> Vec<f64> {
        self.checks.iter().map(|check| check.deviation).collect()
    }

    /// "pass", or how many rows do not.
    fn verdict(&self) -> String {
        let count = |verdict| self.checks.iter().filter(|check| check.verdict() == verdict).count();
        match (count(Verdict::Miss), count(Verdict::Known)) {
            (0, 0) => Verdict::Pass.name().to_owned(),
            (0, known) => format!("{}: {known}", Verdict::Known.name()),
            (missed, _) => format!("{}: {missed}", Verdict::Miss.name()),
        }
    }

    /// Smallest and largest limit.
    fn tolerance(&self) -> String {
        let limits = || self.checks.iter().map(|check| check.tolerance.limit);
        let (low, high) = (limits().fold(f64::INFINITY, f64::min), limits().fold(0.0, max_or_nan));
        if high / low > 1.005 { format!("{} to {}", share(low), share(high)) } else { share(high) }
    }
}

/// In order of first appearance.
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

/// A share in per cent, or, where that is too small to read, as it is.
fn share(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude == 0.0 {
        "0".to_owned()
    } else if magnitude < 1e-4 {
        format!("{value:.0e}").replace('-', "−")
    } else {
        format!("{:.2} %", 100.0 * value).replace('-', "−")
    }
}

/// The same with its sign.
fn signed(value: f64) -> String {
    if value > 0.0 { format!("+{}", share(value)) } else { share(value) }
}

/// The line that sums up everything.
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

/// One line for each quantity, for the terminal.
#[must_use]
pub fn table(checks: &[Check]) -> String {
    let mut rows = vec![["quantity", "checks", "mean", "rms", "largest", "tolerance", "verdict"].map(str::to_owned)];
    for group in groups(checks) {
        let deviations = group.deviations();
        let several = |text: String| if deviations.len() > 1 { text } else { String::new() };
        rows.push([
            group.quantity.to_owned(),
            deviations.len().to_string(),
            several(signed(mean(&deviations))),
            several(share(rms(&deviations))),
            signed(largest(deviations.iter().copied())),
            group.tolerance(),
            group.verdict(),
        ]);
    }
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..7).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let cells = row.iter().zip(&widths).enumerate().map(|(i, (cell, width))| match i {
            0 | 6 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    }
    for check in checks.iter().filter(|check| check.verdict() == Verdict::Miss) {
        let Check { quantity, case, tolerance, .. } = check;
        let (off, limit) = (signed(check.deviation), share(tolerance.limit));
        let _ = writeln!(text, "MISS: {quantity}: {case}: {off}, tolerance {limit} ({})", tolerance.source);
    }
    for group in groups(checks) {
        let known = group.checks.iter().find(|check| check.verdict() == Verdict::Known);
        if let Some(known) = known.and_then(|check| check.known) {
            let _ = writeln!(text, "known of the built-in law: {}: {}", group.quantity, known.remark);
        }
    }
    text + &verdict(checks) + "\n"
}

/// `validation.md`: the summary, then every row.
#[must_use]
pub fn markdown(checks: &[Check], law: &str) -> String {
    let mut text = format!("# Validation\n\nLaw: {law}.\n\n{}.\n\n", verdict(checks));
    text.push_str(&summary(checks));
    text.push_str(
        "\nDeviations are got / expected − 1 unless the quantity says otherwise; the verdict is on each row below, the mean says whether the law is off to one side.\n",
    );
    for group in groups(checks) {
        let _ = write!(text, "\n## {}\n\n", group.quantity);
        let mut references: Vec<&str> = group.checks.iter().map(|check| check.reference).collect();
        references.dedup();
        let mut sources: Vec<&str> = group.checks.iter().map(|check| check.tolerance.source).collect();
        sources.sort_unstable();
        sources.dedup();
        let _ = write!(text, "Reference: {}. Tolerance: {}.\n\n", references.join("; "), sources.join("; "));
        if let Some(known) = group.checks.iter().find_map(|check| check.known) {
            let _ = write!(text, "On record for the built-in law: {}.\n\n", known.remark);
        }
        text.push_str(
            "| case | expected | got | unit | deviation | tolerance | verdict |\n|---|---|---|---|---|---|---|\n",
        );
        let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| format!("{value:.6e}"));
        for check in &group.checks {
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} | {} |",
                check.case,
                number(check.expected),
                number(check.got),
                check.unit,
                signed(check.deviation),
                share(check.tolerance.limit),
                check.verdict().name()
            );
        }
    }
    text
}

/// The summary as a table in Markdown.
fn summary(checks: &[Check]) -> String {
    let mut text = String::from(
        "| quantity | checks | mean deviation | rms | largest | tolerance | verdict |\n|---|---|---|---|---|---|---|\n",
    );
    for group in groups(checks) {
        let deviations = group.deviations();
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} |",
            group.quantity,
            deviations.len(),
            signed(mean(&deviations)),
            share(rms(&deviations)),
            signed(largest(deviations.iter().copied())),
            group.tolerance(),
            group.verdict()
        );
    }
    text
}
