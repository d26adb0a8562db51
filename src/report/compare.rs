//! What is written about a comparison of unloading laws: `summary.json`, `comparison.csv` and the table on the terminal.

use std::fmt::Write as _;

use super::inputs::Inputs;
use super::{overview, terminal};
use crate::compare::{Comparison, Origin};
use crate::error::Error;
use crate::law::LawChoice;
use crate::provenance::Provenance;
use crate::scenario::Scenario;
use crate::scene::results::compare::{self as results, Row};
use crate::scene::results::{fields, lists};
use crate::units::aligned::aligned;
use crate::units::four_digits;
use crate::units::rounded::quantity;

/// The peak in one line.
pub fn state(comparison: &Comparison) -> String {
    let (point, peak) = (&comparison.bodies.yield_point, &comparison.peak);
    let origin = match comparison.origin {
        Origin::Plm => "from the PLM",
        Origin::Given => "as given",
    };
    let mut text = format!(
        "peak {origin}: indentation {} ({} x yield), force {}, contact radius {}",
        quantity(peak.indentation * point.indentation, "m"),
        four_digits(peak.indentation),
        quantity(peak.force * point.force, "N"),
        quantity(peak.radius * point.contact_radius, "m"),
    );
    let _ = writeln!(text, ", spent work {}", quantity(comparison.peak.spent * point.force * point.indentation, "J"));
    text
}

/// The table for the terminal.
pub fn table(comparison: &Comparison, rows: &[Row]) -> String {
    state(comparison) + &terminal::table(&results::row(), rows)
}

/// `comparison.csv`.
pub fn csv(rows: &[Row]) -> Result<Vec<u8>, Error> {
    super::rows::csv(&results::row(), rows.iter().cloned())
}

/// `summary.json`.
pub fn summary(
    comparison: &Comparison,
    rows: &[Row],
    warnings: &[String],
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, Error> {
    let mut all = fields(&results::peak(), comparison);
    all.insert("laws".to_owned(), lists(&results::row(), rows));
    all.insert("warnings".to_owned(), warnings.into());
    super::summary::of(all, inputs, provenance)
}

/// The inputs of a comparison, without its peak and its laws.
pub fn inputs(scenario: &Scenario) -> Inputs {
    Inputs::of(&scenario.as_given()).beginning_with(&[
        "sphere.radius",
        "sphere.youngs_modulus",
        "sphere.poissons_ratio",
        "sphere.material",
        "half_space.youngs_modulus",
        "half_space.poissons_ratio",
        "half_space.yield_strength",
        "half_space.hardness",
        "half_space.material",
        "law.plm.",
    ])
}

/// What `check` prints of a comparison.
pub fn overview(scenario: &Scenario, comparison: &Comparison) -> String {
    let mut rows = overview::rows(&inputs(scenario));
    let names: Vec<String> = comparison.laws.iter().map(LawChoice::name).collect();
    rows.push(["laws".to_owned(), names.join(", ")]);
    rows.push([String::new(), String::new()]);
    rows.extend(overview::paired(&comparison.bodies.pair));
    aligned(&rows, |_| true)
}
