//! `summary.json` of a table, and its lines for the terminal.

use std::fmt::Write as _;

use serde::Serialize;

use super::ReportError;
use super::inputs::Inputs;
use crate::plan::random;
use crate::plan::{Cases, Plan};
use crate::provenance::Provenance;
use crate::sweep::sidecar::Tally;
use crate::sweep::statistics::Distribution;

#[derive(Serialize)]
struct Results<'a> {
    rows: u64,
    failures: u64,
    /// Rows that the law has no answer for; left out where there are none.
    #[serde(skip_serializing_if = "is_zero")]
    outside_law: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    restitution: Option<Distribution>,
    #[serde(skip_serializing_if = "Option::is_none")]
    random: Option<Vec<Random>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    seed: Option<u64>,
    /// Of the scene, and of rows in the table the worst of each kind.
    warnings: &'a [String],
}

/// A random key, as it was drawn.
#[derive(Serialize)]
struct Random {
    key: &'static str,
    distribution: &'static str,
    /// Mean and standard deviation before truncation, or the two ends; SI.
    parameters: [f64; 2],
    /// In words.
    truncated_to: String,
    /// Share of the distribution that lies in the allowed range.
    kept: f64,
}

/// `summary.json`.
///
/// # Errors
/// [`ReportError::Json`].
pub fn summary(
    plan: &Plan,
    tally: &Tally,
    warnings: &[String],
    provenance: &Provenance,
) -> Result<String, ReportError> {
    let (random, seed) = match &plan.cases {
        Cases::MonteCarlo { seed, variables, .. } => (Some(variables.iter().map(random_key).collect()), Some(*seed)),
        Cases::Grid(_) => (None, None),
    };
    let restitution = tally.statistics.distribution();
    let results = Results {
        rows: tally.rows,
        failures: tally.failures,
        outside_law: tally.outside_law,
        restitution,
        random,
        seed,
        warnings,
    };
    super::summary::of(results, &Inputs::of_plan(plan), provenance)
}

fn random_key(variable: &random::Variable) -> Random {
    let (distribution, parameters) = match variable.distribution {
        random::Distribution::Uniform { from, to } => ("uniform", [from, to]),
        random::Distribution::Normal { mean, sd } => ("normal", [mean, sd]),
        random::Distribution::Lognormal { mean, sd } => ("lognormal", [mean, sd]),
    };
    let key = variable.key;
    Random { key: key.path, distribution, parameters, truncated_to: key.quantity.allowed(), kept: variable.kept() }
}

#[allow(clippy::trivially_copy_pass_by_ref)] // as serde asks
fn is_zero(count: &u64) -> bool {
    *count == 0
}

/// What a person wants to know of a finished table.
#[must_use]
pub fn lines(tally: &Tally) -> String {
    let mut text = format!("{} rows, {} without a result\n", tally.rows, tally.failures);
    if tally.outside_law > 0 {
        let _ = writeln!(text, "{} rows where the law has no answer (status outside_law)", tally.outside_law);
    }
    if let Some(e) = tally.statistics.distribution() {
        let _ = writeln!(text, "restitution: mean {:.6}, standard deviation {:.6}", e.mean, e.standard_deviation);
        let (low, middle, high) = (e.quantile_05, e.quantile_50, e.quantile_95);
        let _ = writeln!(text, "quantiles:   5 % {low:.6}, 50 % {middle:.6}, 95 % {high:.6}");
    }
    text
}
