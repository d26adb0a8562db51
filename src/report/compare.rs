//! What is written about a comparison of unloading laws: `summary.json`, `comparison.csv` and the table on the terminal.

use std::fmt::Write as _;

use serde::Serialize;

use super::ReportError;
use super::inputs::Inputs;
use super::rows::written;
use super::summary::pretty;
use super::table::aligned;
use crate::compare::{Comparison, Origin};
use crate::provenance::Provenance;
use crate::units::rounded::{number, quantity};

/// One law in the table; deviations are relative to the finite elements of the same peak.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The law, or `finite_elements`.
    pub law: String,
    /// δ_r.
    pub residual_indentation_m: Option<f64>,
    /// δ_r/δ_m.
    pub residual_share: Option<f64>,
    /// Of unloading.
    #[serde(rename = "recovered_energy_J")]
    pub recovered_energy: Option<f64>,
    /// √(recovered/spent).
    pub restitution: Option<f64>,
    /// δ_r over that of the finite elements, less 1.
    pub residual_deviation: Option<f64>,
    /// The same of the recovered energy.
    pub recovered_energy_deviation: Option<f64>,
    /// The same of e.
    pub restitution_deviation: Option<f64>,
    /// `ok`, or `outside_law`.
    pub status: &'static str,
}

#[derive(Serialize)]
struct Summary<'a> {
    peak: Peak,
    laws: &'a [Row],
    warnings: &'a [String],
    inputs: &'a Inputs,
    #[serde(flatten)]
    provenance: &'a Provenance,
}

#[derive(Serialize)]
struct Peak {
    origin: &'static str,
    indentation_m: f64,
    indentation_over_yield: f64,
    #[serde(rename = "force_N")]
    force: f64,
    contact_radius_m: f64,
    sphere_indentation_m: Option<f64>,
    #[serde(rename = "spent_work_J")]
    spent_work: f64,
}

/// The rows: the finite elements first, where there are some, then the laws.
#[must_use]
pub fn rows(comparison: &Comparison) -> Vec<Row> {
    let point = &comparison.bodies.yield_point;
    let energy = point.force * point.indentation;
    let reference = comparison.finite_elements();
    let row = |law: String, share: f64, recovered: f64, e: f64| {
        // shares of the peak, as the peaks differ by up to 1 %
        let deviation = |got: f64, want: fn(&crate::reference::quasi_static::Unloaded) -> f64| {
            reference.map(|row| got / want(row) - 1.0)
        };
        Row {
            law,
            residual_indentation_m: Some(share * comparison.peak.indentation * point.indentation),
            residual_share: Some(share),
            recovered_energy: Some(recovered * energy),
            restitution: Some(e),
            residual_deviation: deviation(share, |row| row.residual_share),
            recovered_energy_deviation: deviation(
                recovered / (comparison.peak.force * comparison.peak.indentation),
                |row| row.restitution * row.restitution * row.spent / (row.force * row.indentation),
            ),
            restitution_deviation: deviation(e, |row| row.restitution),
            status: "ok",
        }
    };
    let finite_elements = reference.map(|fe| {
        let recovered = fe.restitution * fe.restitution * fe.spent;
        let scale = comparison.peak.force * comparison.peak.indentation / (fe.force * fe.indentation);
        row("finite_elements".to_owned(), fe.residual_share, recovered * scale, fe.restitution)
    });
    let laws = comparison.compared().into_iter().map(|one| match one.unloading {
        Ok(unloading) => row(
            one.name,
            unloading.peak.residual() / comparison.peak.indentation,
            unloading.stored(comparison.peak.indentation),
            comparison.restitution(&unloading),
        ),
        Err(_) => Row {
            law: one.name,
            residual_indentation_m: None,
            residual_share: None,
            recovered_energy: None,
            restitution: None,
            residual_deviation: None,
            recovered_energy_deviation: None,
            restitution_deviation: None,
            status: "outside_law",
        },
    });
    finite_elements.into_iter().chain(laws).collect()
}

/// The peak in a few lines.
#[must_use]
pub fn state(comparison: &Comparison) -> String {
    let (point, peak) = (&comparison.bodies.yield_point, &comparison.peak);
    let origin = match comparison.origin {
        Origin::Plm => "from the PLM",
        Origin::Given => "as given",
    };
    let mut text = format!(
        "peak {origin}: indentation {} ({} x yield), force {}, contact radius {}",
        quantity(peak.indentation * point.indentation, "m"),
        number(peak.indentation),
        quantity(peak.force * point.force, "N"),
        quantity(peak.radius * point.contact_radius, "m"),
    );
    let _ = writeln!(text, ", spent work {}", quantity(comparison.peak.spent * point.force * point.indentation, "J"));
    text
}

/// For the terminal.
#[must_use]
pub fn table(comparison: &Comparison) -> String {
    let percent = |value: Option<f64>| value.map_or_else(String::new, |share| format!("{:+.1} %", 100.0 * share));
    let mut lines =
        vec![["law", "residual", "share", "recovered", "e", "residual", "energy", "e against FE"].map(str::to_owned)];
    lines.extend(rows(comparison).into_iter().map(|row| {
        let of = |value: Option<f64>, unit| value.map_or_else(|| "-".to_owned(), |value| quantity(value, unit));
        let ratio = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.4}"));
        let remark = if row.status == "ok" { percent(row.restitution_deviation) } else { "no answer here".to_owned() };
        [
            row.law,
            of(row.residual_indentation_m, "m"),
            ratio(row.residual_share),
            of(row.recovered_energy, "J"),
            ratio(row.restitution),
            percent(row.residual_deviation),
            percent(row.recovered_energy_deviation),
            remark,
        ]
    }));
    state(comparison) + &aligned(&lines)
}

/// `comparison.csv`.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn csv(rows: &[Row]) -> Result<Vec<u8>, ReportError> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    for row in rows {
        csv.serialize(row)?;
    }
    written(csv)
}

/// `summary.json`.
///
/// # Errors
/// [`ReportError::Json`], which numbers and text do not give.
pub fn summary(
    comparison: &Comparison,
    laws: &[Row],
    warnings: &[String],
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, ReportError> {
    let (point, peak) = (&comparison.bodies.yield_point, &comparison.peak);
    let pair = &comparison.bodies.pair;
    let peak = Peak {
        origin: if comparison.origin == Origin::Plm { "plm" } else { "given" },
        indentation_m: peak.indentation * point.indentation,
        indentation_over_yield: peak.indentation,
        force: peak.force * point.force,
        contact_radius_m: peak.radius * point.contact_radius,
        sphere_indentation_m: peak.elastic_approach.map(|e| pair.sphere_compliance * e * point.indentation),
        spent_work: peak.spent * point.force * point.indentation,
    };
    pretty(&Summary { peak, laws, warnings, inputs, provenance })
}
