//! `summary.json` of a table, and its lines for the terminal.

use std::fmt::Write as _;

use serde::Serialize;
use serde_json::{Map, Value};

use super::ReportError;
use crate::law::{LawChoice, UnloadingExponent};
use crate::scenario::KEYS;
use crate::sweep::caution::cautions;
use crate::sweep::plan::{Cases, Plan};
use crate::sweep::random;
use crate::sweep::sidecar::Tally;
use crate::sweep::statistics::Distribution;

#[derive(Serialize)]
struct Summary<'a> {
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
    /// Of rows in the table, the worst of each kind.
    warnings: Vec<String>,
    /// The numbers that are the same in all rows, SI, with the names of columns.
    inputs: Map<String, Value>,
    provenance: Provenance<'a>,
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

/// Where a table comes from: enough to repeat it.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Provenance<'a> {
    /// Version of the program.
    pub version: &'a str,
    /// SHA-256 of the scenario's text and overrides.
    pub scenario_sha256: &'a str,
    /// The command line.
    pub command: &'a str,
}

/// `summary.json`.
///
/// # Errors
/// [`ReportError::Json`].
pub fn summary(plan: &Plan, tally: &Tally, provenance: Provenance) -> Result<String, ReportError> {
    let (random, seed) = match &plan.cases {
        Cases::MonteCarlo { seed, variables, .. } => (Some(variables.iter().map(random_key).collect()), Some(*seed)),
        Cases::Grid(_) => (None, None),
    };
    let restitution = tally.statistics.distribution();
    let summary = Summary {
        rows: tally.rows,
        failures: tally.failures,
        outside_law: tally.outside_law,
        restitution,
        random,
        seed,
        warnings: cautions(plan),
        inputs: inputs(plan),
        provenance,
    };
    Ok(serde_json::to_string_pretty(&summary)? + "\n")
}

fn inputs(plan: &Plan) -> Map<String, Value> {
    let (scene, varied) = (&plan.scene, plan.paths());
    let varies = |path: &str| varied.contains(&path);
    let twins = |path: &str| match path {
        "sphere.radius" => varies("sphere.diameter"),
        // that of the fall
        "impact.speed" => scene.drop_height.is_some(),
        path => path.starts_with("law.") && varies("law"),
    };
    let same = KEYS.iter().filter(|key| key.path != "sphere.diameter" && !varies(key.path) && !twins(key.path));
    let number = |value: f64| if value.is_finite() { Value::from(value) } else { Value::from("rigid") };
    let mut inputs: Map<String, Value> =
        same.filter_map(|key| Some((key.column(), number((key.get)(scene)?)))).collect();
    if plan.is_plastic() && !varies("law") {
        inputs.insert("law".to_owned(), Value::from(scene.law.name()));
        let is_plm = matches!(scene.law, LawChoice::Plm(_));
        if is_plm && scene.exponent == UnloadingExponent::PressureShape && !varies("law.plm.unloading_exponent") {
            inputs.insert("law_plm_unloading_exponent".to_owned(), Value::from("pressure-shape"));
        }
    }
    if !varies("solver.method") {
        inputs.insert("solver_method".to_owned(), Value::from(scene.solver.method.name()));
    }
    inputs
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
