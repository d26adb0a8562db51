//! How many rows a second this machine computes and writes.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use rayon::prelude::*;

use super::SweepError;
use super::evaluator::{Evaluator, Rows};
use super::form::Format;
use super::job::Job;
use crate::output::OutputDirectory;
use crate::plan::{Plan, Source};

/// Rows per second, each the best of all rounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throughput {
    /// Computing only, nothing written.
    pub compute: f64,
    /// Computing and writing a CSV file.
    pub csv: f64,
    /// Computing and writing a Parquet file; `None` in a build without Parquet.
    pub parquet: Option<f64>,
}

/// Measures a plan, writing its tables into `directory`.
pub fn throughput(plan: &Plan, directory: &OutputDirectory, rounds: u32) -> Result<Throughput, SweepError> {
    let mut best = Throughput { compute: 0.0, csv: 0.0, parquet: None };
    for _ in 0..rounds {
        best.compute = best.compute.max(compute_rate(plan));
        best.csv = best.csv.max(write_rate(plan, directory, Format::Csv)?);
        if cfg!(feature = "parquet") {
            let rate = write_rate(plan, directory, Format::Parquet)?;
            best.parquet = Some(best.parquet.map_or(rate, |other| other.max(rate)));
        }
    }
    Ok(best)
}

/// Rows computed at a time.
const LONGEST: u64 = 4096;

/// Rows per second of computing only.
#[allow(clippy::cast_precision_loss)]
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
#[allow(clippy::cast_precision_loss)]
fn write_rate(plan: &Plan, directory: &OutputDirectory, format: Format) -> Result<f64, SweepError> {
    let started = Instant::now();
    let job = Job {
        plan,
        shard: None,
        format,
        rows_per_part: None,
        directory,
        source: &Source::default(),
        progress: &|_, _| (),
        is_cancelled: &AtomicBool::new(false),
    };
    let written = job.run()?;
    Ok(written.tally.rows as f64 / started.elapsed().as_secs_f64())
}
