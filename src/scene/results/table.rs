//! The results of a whole table, beside its rows. The entries below say what the fields of the types are.

use super::entry::{Reported, file, results};

/// Counts and statistics of the rows of a table.
#[derive(Debug, Clone, Copy)]
pub struct Totals {
    pub rows: u64,
    pub failures: u64,
    pub outside_law: u64,
    pub restitution: Option<Distribution>,
}

/// Statistics of the restitutions of random cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution {
    pub samples: u64,
    pub mean: f64,
    pub standard_deviation: f64,
    pub quantile_05: f64,
    pub quantile_50: f64,
    pub quantile_95: f64,
    pub quantile_resolution: f64,
}

/// A random key, as it was drawn.
#[derive(Debug, Clone)]
pub struct Drawn {
    pub key: &'static str,
    pub distribution: &'static str,
    pub parameters: [f64; 2],
    pub truncated_to: String,
    pub kept: f64,
}

/// The results of the rows, in the order of `summary.json`.
pub fn totals() -> Vec<Reported<Totals>> {
    results! { |of: Totals|
        /// Rows of the table.
        "rows": of.rows;
        /// Rows without a result.
        "failures": of.failures;
        /// Rows that the law has no answer for.
        "outside_law" if OUTSIDE: (of.outside_law > 0).then_some(of.outside_law);
        /// Restitutions that the distribution is made of.
        "restitution.samples" if RANDOM: of.restitution.map(|e| e.samples);
        /// Mean of the restitution.
        "restitution.mean" if RANDOM: of.restitution.map(|e| e.mean);
        /// Standard deviation of the restitution, with n - 1 in the denominator.
        "restitution.standard_deviation" in Deviation if RANDOM: of.restitution.map(|e| e.standard_deviation);
        /// 5 % of the restitutions are smaller.
        "restitution.quantile_05" if RANDOM: of.restitution.map(|e| e.quantile_05);
        /// Half of the restitutions are smaller.
        "restitution.quantile_50" if RANDOM: of.restitution.map(|e| e.quantile_50);
        /// 5 % of the restitutions are larger.
        "restitution.quantile_95" if RANDOM: of.restitution.map(|e| e.quantile_95);
        /// 0 where the quantiles are exact (up to 10^6 samples), else the width of the bins that they come from.
        "restitution.quantile_resolution" if RANDOM: of.restitution.map(|e| e.quantile_resolution);
    }
}

/// The description of every random key.
pub fn drawn() -> Vec<Reported<Drawn>> {
    results! { |of: Drawn|
        /// Path of the key.
        "key": of.key;
        /// Name of its distribution: `uniform`, `normal` or `lognormal`.
        "distribution": of.distribution;
        /// Mean and standard deviation before truncation, or the two ends; SI.
        "parameters": of.parameters.to_vec();
        /// Range that the values are cut to.
        "truncated_to": of.truncated_to.clone();
        /// Share of the distribution that lies in that range.
        "kept": of.kept;
    }
}

/// The files with these results, as Markdown.
pub(super) fn files() -> String {
    file("Tables: `summary.json`", &totals()) + &file("Tables: every random key in `summary.json`", &drawn())
}
