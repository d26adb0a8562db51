//! How many rows a second this machine computes, and makes CSV of.

use std::hint::black_box;

use super::measure::time_call;
use crate::error::Error;
use crate::files::Progress;
use crate::report::run::table;
use crate::scenario::plan::Plan;
use crate::table::Rows;
use crate::table::format::csv::CsvEncoder;

/// Rows a second of a plan on all cores, in memory: computed alone, and with their lines of CSV, each the best of all rounds.
pub fn throughput(plan: &Plan, rounds: u32) -> Result<[f64; 2], Error> {
    let csv = CsvEncoder::new(plan);
    let mut best = [0.0; 2];
    for _ in 0..rounds {
        let rates =
            [rows_per_second(plan, |rows| rows.results.len())?, rows_per_second(plan, |rows| csv.rows_as_lines(rows))?];
        best = [0, 1].map(|k| f64::max(best[k], rates[k]));
    }
    Ok(best)
}

fn rows_per_second<P: Send>(plan: &Plan, make: impl Fn(&Rows) -> P + Sync + Send) -> Result<f64, Error> {
    let (tally, ns) =
        time_call(|| table::compute_rows(plan, &Progress::default(), make, |piece| drop(black_box(piece))));
    Ok(1e9 * tally?.rows as f64 / ns)
}
