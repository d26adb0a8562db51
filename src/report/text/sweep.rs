//! The results of a whole table, beside its rows: its `summary.json`, and its lines for the terminal.

use std::fmt::Write as _;

use serde_json::{Map, Value};

use crate::scenario::plan::{Cases, Plan, Variable};
use crate::scenario::scene::results::{Reported, fields, lists, results};
use crate::table::Tally;
use crate::table::statistics::Distribution;

/// Counts of the rows of a table; if the cases are random, the statistics of their restitutions.
type Totals<'a> = (&'a Tally, Option<Distribution>);

/// The results of the rows, in the order of `summary.json`.
pub fn totals<'a>() -> Vec<Reported<Totals<'a>>> {
    results! { |totals: Totals<'a>|
        /// Rows of the table.
        "rows": totals.0.rows;
        /// Rows without a result.
        "failures": totals.0.failures;
        /// Rows that the law has no answer for.
        "outside_law" if OUTSIDE: (totals.0.outside_law > 0).then_some(totals.0.outside_law);
        /// Restitutions that the distribution is made of.
        "restitution.samples" if RANDOM: totals.1.map(|e| e.samples);
        /// Mean of the restitution.
        "restitution.mean" if RANDOM: totals.1.map(|e| e.mean);
        /// Standard deviation of the restitution, with n - 1 in the denominator.
        "restitution.standard_deviation" in Deviation if RANDOM: totals.1.map(|e| e.standard_deviation);
        /// 5 % of the restitutions are smaller.
        "restitution.quantile_05" if RANDOM: totals.1.map(|e| e.quantile_05);
        /// Half of the restitutions are smaller.
        "restitution.quantile_50" if RANDOM: totals.1.map(|e| e.quantile_50);
        /// 5 % of the restitutions are larger.
        "restitution.quantile_95" if RANDOM: totals.1.map(|e| e.quantile_95);
        /// 0 where the quantiles are exact (up to 10^6 samples), else the width of the bins that they come from.
        "restitution.quantile_resolution" if RANDOM: totals.1.map(|e| e.quantile_resolution);
    }
}

/// The description of every random key.
pub fn drawn() -> Vec<Reported<Variable>> {
    results! { |variable: Variable|
        /// Path of the key.
        "key": variable.key.path;
        /// Name of its distribution: `uniform`, `normal` or `lognormal`.
        "distribution": variable.distribution.parts().0;
        /// Mean and standard deviation before truncation, or the two ends; SI.
        "parameters": variable.distribution.parts().1.to_vec();
        /// Range that the values are cut to.
        "truncated_to": variable.key.quantity.allowed();
        /// Share of the distribution that lies in that range.
        "kept": variable.share_in_range();
    }
}

/// The results by their names. The warnings are about the scene; of those about rows the worst of each kind.
pub fn found(plan: &Plan, tally: &Tally, warnings: &[String]) -> Map<String, Value> {
    let mut results = fields(&totals(), &(tally, tally.statistics.distribution()));
    if let Cases::MonteCarlo { seed, variables, .. } = &plan.cases {
        results.insert("random".to_owned(), lists(&drawn(), variables));
        results.insert("seed".to_owned(), (*seed).into());
    }
    results.insert("warnings".to_owned(), warnings.into());
    results
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
