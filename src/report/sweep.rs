//! `summary.json` of a table, and its lines for the terminal.

use std::fmt::Write as _;

use serde::Serialize;

use super::inputs::Inputs;
use crate::error::Error;
use crate::plan::random;
use crate::plan::{Cases, Plan};
use crate::provenance::Provenance;
use crate::scene::results::table::{Drawn, Totals, drawn, totals};
use crate::scene::results::{Fields, fields};
use crate::sweep::count::Tally;

#[derive(Serialize)]
struct Results<'a> {
    #[serde(flatten)]
    totals: Fields,
    #[serde(skip_serializing_if = "Option::is_none")]
    random: Option<Vec<Fields>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    seed: Option<u64>,
    /// Warnings about the scene, and of those about rows the worst of each kind.
    warnings: &'a [String],
}

/// `summary.json`.
pub fn summary(plan: &Plan, tally: &Tally, warnings: &[String], provenance: &Provenance) -> Result<String, Error> {
    let (random, seed) = match &plan.cases {
        Cases::MonteCarlo { seed, variables, .. } => {
            (Some(variables.iter().map(|one| fields(&drawn(), &random_key(one))).collect()), Some(*seed))
        }
        Cases::Grid(_) => (None, None),
    };
    let Tally { rows, failures, outside_law, ref statistics, .. } = *tally;
    let of = Totals { rows, failures, outside_law, restitution: statistics.distribution() };
    let results = Results { totals: fields(&totals(), &of), random, seed, warnings };
    super::summary::of(results, &Inputs::of_plan(plan), provenance)
}

fn random_key(variable: &random::Variable) -> Drawn {
    let (distribution, parameters) = match variable.distribution {
        random::Distribution::Uniform { from, to } => ("uniform", [from, to]),
        random::Distribution::Normal { mean, sd } => ("normal", [mean, sd]),
        random::Distribution::Lognormal { mean, sd } => ("lognormal", [mean, sd]),
    };
    let key = variable.key;
    Drawn { key: key.path, distribution, parameters, truncated_to: key.quantity.allowed(), kept: variable.kept() }
}

/// The lines about a finished table, for the terminal.
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
