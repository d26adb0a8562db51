//! The results of a whole table, beside its rows: its `summary.json`, and the blocks for people.

use serde_json::{Map, Value};

use super::blocks::Block;
use super::terminal::{Imprint, result_lines};
use crate::impact::PeenedSurface;
use crate::results::{
    PEENING_MEANS, RESTITUTION, ResultColumn, ResultSpec, dimension_of, result_specs, to_field_list, to_fields,
};
use crate::scenario::plan::{Cases, Plan, Variable};
use crate::table::Tally;
use crate::table::statistics::ColumnStatistics;
use crate::units::{format_result, quantities};

/// Counts of the rows of a table; if the cases are random, the statistics of their restitutions and of their other columns, and the
/// mean dent and shot of shot peening.
type Totals<'a> = (&'a Tally, Option<ColumnStatistics>, Option<Value>, Option<PeenedSurface>);

/// The results of the rows, in the order of `summary.json`.
pub fn total_results<'a>() -> Vec<ResultSpec<Totals<'a>>> {
    result_specs! { |totals: Totals<'a>|
        /// Rows of the table.
        "rows": totals.0.rows;
        /// Rows without a result.
        "failures": totals.0.failures;
        /// Rows with status `outside_law`: the law has no result.
        "outside_law" if OUTSIDE: (totals.0.outside_law > 0).then_some(totals.0.outside_law);
        /// Number of restitutions in the distribution.
        "restitution.samples" if RANDOM: totals.1.map(|e| e.samples);
        /// Mean of the restitution.
        "restitution.mean" if RANDOM: totals.1.map(|e| e.mean);
        /// Standard deviation of the restitution, with n - 1 in the denominator.
        "restitution.standard_deviation" in Deviation if RANDOM: totals.1.map(|e| e.standard_deviation);
        /// 5 % quantile of the restitution.
        "restitution.quantile_05" if RANDOM: totals.1.map(|e| e.quantile_05);
        /// Median of the restitution.
        "restitution.quantile_50" if RANDOM: totals.1.map(|e| e.quantile_50);
        /// 95 % quantile of the restitution.
        "restitution.quantile_95" if RANDOM: totals.1.map(|e| e.quantile_95);
        /// 0 if the quantiles are exact (up to 10^6 samples), otherwise the width of their bins.
        "restitution.quantile_resolution" if RANDOM: totals.1.map(|e| e.quantile_resolution);
        /// Impacts per area for the coverage, from the mean area of the dents.
        "peening.impacts_for_coverage_per_m2" in ArealNumber as "impacts for the coverage" if RANDOM_PEENING:
            totals.3.map(|mean| mean.impacts_per_area());
        /// Mass of shot per area for this coverage, from the mean mass of the shots.
        "peening.mass_for_coverage_kg_per_m2" in ArealMass as "mass for the coverage" if RANDOM_PEENING:
            totals.3.map(|mean| mean.mass_per_area());
        /// Time for this coverage.
        "peening.time_for_coverage_s" in Time as "time for the coverage" if RANDOM_PEENING:
            totals.3.filter(|mean| mean.request.mass_flux.is_some()).map(|mean| mean.time());
        /// Covered fraction of the surface after the time that the scenario gives.
        "peening.coverage_after_time" in Percent as "coverage after the time" if RANDOM_PEENING:
            totals.3.filter(|mean| mean.request.time.is_some()).map(|mean| mean.coverage_after_time());
        /// Distribution of every other column that output.columns or output.picture names, see below.
        "columns" if NAMED_COLUMNS: totals.2.clone();
    }
}

/// The distribution of a column of random cases.
pub fn distributions() -> Vec<ResultSpec<(ResultColumn, ColumnStatistics)>> {
    result_specs! { |one: (ResultColumn, ColumnStatistics)|
        /// Name of the column, with its unit.
        "column": one.0.name;
        /// Number of values in the distribution.
        "samples": one.1.samples;
        /// Mean, in the unit of the column.
        "mean": one.1.mean;
        /// Standard deviation, with n - 1 in the denominator.
        "standard_deviation" in Deviation: one.1.standard_deviation;
        /// 5 % quantile.
        "quantile_05": one.1.quantile_05;
        /// Median.
        "quantile_50": one.1.quantile_50;
        /// 95 % quantile.
        "quantile_95": one.1.quantile_95;
        /// 0 if the quantiles are exact (up to 10^6 samples), otherwise the width of the widest bin.
        "quantile_resolution": one.1.quantile_resolution;
    }
}

/// The description of every random key.
pub fn random_key_results() -> Vec<ResultSpec<Variable>> {
    result_specs! { |variable: Variable|
        /// Path of the key.
        "key": variable.key.path();
        /// Distribution: `uniform`, `normal` or `lognormal`.
        "distribution": variable.distribution.name_and_parameters().0;
        /// Mean and standard deviation before truncation, or the two ends; SI.
        "parameters": variable.distribution.name_and_parameters().1.to_vec();
        /// Range to which the values are truncated.
        "truncated_to": variable.key.quantity().allowed_range();
        /// Probability of this range before truncation.
        "kept": variable.probability_in_range();
    }
}

/// The results by their names. The warnings are about the scene; of those about rows the worst of each kind.
pub fn summary_fields(plan: &Plan, tally: &Tally, warnings: &[String]) -> Map<String, Value> {
    let all = tally.distributions();
    let peened = mean_surface(plan, tally);
    let (e, others): (Vec<_>, Vec<_>) = all.into_iter().partition(|(column, _)| column.name == RESTITUTION);
    let columns = (!others.is_empty()).then(|| to_field_list(&distributions(), &others));
    let mut results = to_fields(&total_results(), &(tally, e.first().map(|(_, e)| *e), columns, peened));
    if let Cases::MonteCarlo { seed, variables, .. } = &plan.cases {
        results.insert("random".to_owned(), to_field_list(&random_key_results(), variables));
        results.insert("seed".to_owned(), (*seed).into());
    }
    results.insert("warnings".to_owned(), warnings.into());
    results
}

/// The mean dent and the mean shot of random shots.
fn mean_surface(plan: &Plan, tally: &Tally) -> Option<PeenedSurface> {
    let request = plan.input.peening()?;
    let all = tally.distributions();
    let mean = |name: &str| all.iter().find(|(column, _)| column.name == name).map(|(_, of_column)| of_column.mean);
    let [dent_area, shot_mass] = PEENING_MEANS.map(mean);
    Some(PeenedSurface { request, dent_area: dent_area?, shot_mass: shot_mass? })
}

/// The blocks about a finished table.
pub fn result_blocks(plan: &Plan, tally: &Tally) -> Vec<Block> {
    let with_results = tally.rows - tally.failures - tally.outside_law;
    let counts = format!("{} rows: {with_results} with results, {} failed", tally.rows, tally.failures);
    let mut blocks = vec![Block::Sentence(counts)];
    if tally.outside_law > 0 {
        let outside = format!("{} rows outside the range of the law (status outside_law)", tally.outside_law);
        blocks.push(Block::Sentence(outside));
    }
    let (constant, scattered): (Vec<_>, Vec<_>) =
        tally.distributions().into_iter().partition(|(_, all)| all.is_constant && all.samples > 1);
    if !scattered.is_empty() {
        let head = ["random cases", "mean", "standard deviation", "5 %", "50 %", "95 %"].map(str::to_owned);
        let rows = std::iter::once(head).chain(scattered.iter().map(quantiles));
        blocks.extend([Block::EmptyLine, Block::table(rows, usize::MAX)]);
    }
    if let Some(surface) = mean_surface(plan, tally) {
        let mut results = total_results();
        results.retain(|result| result.name.starts_with("peening."));
        let lines = result_lines(&results, &(tally, None, None, Some(surface)), Imprint::OfSprings);
        blocks.extend([Block::EmptyLine, Block::list(lines)]);
    }
    blocks.extend(constant.first().map(|_| Block::EmptyLine));
    for (column, all) in &constant {
        let value = format_result(all.mean, dimension_of(column.name));
        let (name, keys) = (column_label(column), plan.varied_paths().join(" and "));
        let sentence = format!("{name}: {value} in all cases, because this result does not depend on {keys} here");
        blocks.push(Block::Sentence(sentence));
    }
    blocks
}

/// The name of a column in words, without its unit.
fn column_label(column: &ResultColumn) -> String {
    column.name.strip_suffix(dimension_of(column.name).suffix()).unwrap_or(column.name).replace('_', " ")
}

/// The row of a column in the table of random cases: "5 %" has the value above 5 % of all values.
fn quantiles((column, all): &(ResultColumn, ColumnStatistics)) -> [String; 6] {
    let dimension = dimension_of(column.name);
    let values = [all.mean, all.quantile_05, all.quantile_50, all.quantile_95];
    let mut texts = quantities(&values, dimension).into_iter();
    let mut next = || texts.next().unwrap_or_default();
    [column_label(column), next(), format_result(all.standard_deviation, dimension), next(), next(), next()]
}
