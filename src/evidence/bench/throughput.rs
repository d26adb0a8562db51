//! How many rows a second this machine computes and writes.

use std::path::Path;
use std::time::Instant;

use rayon::prelude::*;

use crate::error::Error;
use crate::files::{Counter, Origin, OutputDirectory};
use crate::scenario::Source;
use crate::scenario::plan::Plan;
use crate::table::{Evaluator, Format, Job, Layout, Rows};

/// Rows computed at a time.
const LONGEST: u64 = 4096;

/// Rows a second of a plan: computed alone, as CSV and as Parquet, each the best of all rounds. The tables are written into a
/// folder of their own below `directory`, which goes with them. The last is 0 in a build without Parquet.
pub fn throughput(plan: &Plan, directory: &Path, rounds: u32) -> Result<[f64; 3], Error> {
    let folder = directory.join(format!(".throughput.{}", std::process::id()));
    let tables = OutputDirectory::prepare(&folder, Origin::Command("bench"), true)?;
    let measure = || -> Result<[f64; 3], Error> {
        let mut best = [0.0; 3];
        for _ in 0..rounds {
            let parquet = if cfg!(feature = "parquet") { write_rate(plan, &tables, Format::Parquet)? } else { 0.0 };
            let rates = [compute_rate(plan), write_rate(plan, &tables, Format::Csv)?, parquet];
            best = [0, 1, 2].map(|k| f64::max(best[k], rates[k]));
        }
        Ok(best)
    };
    let best = measure();
    std::fs::remove_dir_all(&folder).map_err(crate::files::unwritable(&folder))?;
    best
}

/// Rows per second of computing only.
pub fn compute_rate(plan: &Plan) -> f64 {
    let total = plan.count();
    let started = Instant::now();
    let evaluator = Evaluator::new(plan);
    let sum: f64 = (0..total.div_ceil(LONGEST))
        .into_par_iter()
        .map(|chunk| {
            let mut rows = Rows::with_capacity(LONGEST, evaluator.n_swept());
            evaluator.rows(chunk * LONGEST..total.min((chunk + 1) * LONGEST), &mut rows);
            rows.results.iter().flatten().map(|row| row.restitution).sum::<f64>()
        })
        .sum();
    std::hint::black_box(sum);
    total as f64 / started.elapsed().as_secs_f64()
}

/// Rows per second of computing and writing a file.
fn write_rate(plan: &Plan, directory: &OutputDirectory, format: Format) -> Result<f64, Error> {
    let started = Instant::now();
    let job = Job {
        plan,
        shard: None,
        format,
        layout: Layout::new(plan),
        directory,
        source: &Source::default(),
        progress: &Counter::default(),
    };
    let written = job.run()?;
    Ok(written.tally.rows as f64 / started.elapsed().as_secs_f64())
}
