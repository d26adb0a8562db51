//! Rows are computed in chunks on all threads, and taken in their order.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::tally::RowOutcome;
use super::{Evaluator, Rows, Tally, classify};
use crate::error::{Error, ErrorKind};
use crate::files::Progress;
use crate::results::ResultColumn;
use crate::scenario::plan::Plan;

/// Computes the rows of a plan.
pub struct ChunkComputer<'a> {
    evaluator: Evaluator<'a>,
    /// The columns with statistics.
    statistics: Vec<ResultColumn>,
    progress: &'a Progress,
    /// Rows of finished chunks: their memory is reused.
    spare: Mutex<Vec<Rows>>,
}

impl<'a> ChunkComputer<'a> {
    pub fn new(plan: &'a Plan, progress: &'a Progress) -> Self {
        let (evaluator, statistics) = (Evaluator::new(plan), plan.statistics_columns());
        Self { evaluator, statistics, progress, spare: Mutex::default() }
    }

    /// Computes the rows of these cases, and encodes them.
    ///
    /// # Errors
    /// [`Error`] of the kind `Stopped` if the progress is asked to stop.
    pub fn compute<P>(
        &self,
        cases: Range<u64>,
        encode: impl FnOnce(&Rows) -> P,
    ) -> Result<(P, Vec<RowOutcome>), Error> {
        if self.progress.is_stopped() {
            return Err(Error::new(ErrorKind::Stopped(130), "the table was stopped"));
        }
        let used: Option<Rows> = self.spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut rows =
            used.unwrap_or_else(|| Rows::with_capacity(cases.end - cases.start, self.evaluator.n_axis_values()));
        rows.clear();
        self.evaluator.append_rows(cases, &mut rows);
        let encoded = encode(&rows);
        let outcomes = rows.results.iter().map(|row| classify(row, &self.statistics)).collect();
        self.spare.lock().unwrap_or_else(PoisonError::into_inner).push(rows);
        Ok((encoded, outcomes))
    }
}

/// Rows that take longer than this \[µs\] are made a few at a time, so that a stop is heard soon.
const SLOW_ROW_US: f64 = 100.0;

/// All rows of a table, in memory. On any thread `encode` makes a piece of some rows, and `take` gets the pieces in order.
///
/// # Errors
/// [`Error`] of the kind `Stopped` if the progress is asked to stop.
pub fn compute_rows<P: Send>(
    plan: &Plan,
    progress: &Progress,
    encode: impl Fn(&Rows) -> P + Sync + Send,
    mut take: impl FnMut(P) + Send,
) -> Result<Tally, Error> {
    let step = if plan.row_time_us() > SLOW_ROW_US { 16 } else { 1024 };
    let computer = ChunkComputer::new(plan, progress);
    let mut tally = Tally::new(plan);
    let cases = |chunk: u64| chunk * step..plan.n_cases().min((chunk + 1) * step);
    let make = |chunk: u64| computer.compute(cases(chunk), &encode);
    ordered_parallel(0..plan.n_cases().div_ceil(step), make, |(piece, outcomes)| {
        take(piece);
        for outcome in outcomes {
            tally.push(outcome);
        }
        Ok(())
    })?;
    Ok(tally)
}

/// Chunks in memory for each thread: enough that few threads wait at the end of a round.
const CHUNKS_PER_THREAD: usize = 16;

/// Makes a chunk of every task on all threads, and takes the chunks in the order of the tasks. While the chunks of one round
/// are taken, those of the next are made.
///
/// # Errors
/// The first error of `make` or `take`; then nothing more is begun.
pub fn ordered_parallel<T: Send, M: Send, E: Send>(
    mut tasks: impl Iterator<Item = T> + Send,
    make: impl Fn(T) -> Result<M, E> + Sync + Send,
    mut take: impl FnMut(M) -> Result<(), E> + Send,
) -> Result<(), E> {
    let mut made: Vec<Result<M, E>> = Vec::new();
    loop {
        let round: Vec<T> = tasks.by_ref().take(CHUNKS_PER_THREAD * rayon::current_num_threads()).collect();
        if round.is_empty() && made.is_empty() {
            return Ok(());
        }
        let ready = std::mem::take(&mut made);
        let (result, next) = rayon::join(
            || ready.into_iter().try_for_each(|chunk| take(chunk?)),
            || round.into_par_iter().map(&make).collect(),
        );
        result?;
        made = next;
    }
}
