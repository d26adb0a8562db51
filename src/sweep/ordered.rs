//! Pieces of a table are made on all threads and written in order, while the next pieces are being made.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::Scope;

use super::SweepError;
use super::count::Count;
use super::sidecar::Tally;

/// Rows that were made together.
pub(super) struct Made<T> {
    /// The encoded rows.
    pub(super) output: T,
    /// How each row counts.
    pub(super) counts: Vec<Count>,
}

/// Makes the rows after those in `tally`, up to row `total`, and counts in `tally` the rows that were written. `make`
/// makes a piece of rows on one of the threads; `put` writes the pieces in their order. `length` says how many rows the
/// next piece has. If `make` returns fewer rows, or fails with `None`, the run was cancelled: later rows are neither
/// written nor counted.
///
/// # Errors
/// Those of `make` and `put`.
pub(super) fn fill<T: Send>(
    tally: &mut Tally,
    total: u64,
    mut length: impl FnMut() -> u64 + Send,
    make: impl Fn(Range<u64>) -> Result<Made<T>, Option<SweepError>> + Sync,
    mut put: impl FnMut(T) -> Result<(), SweepError> + Send,
) -> Result<(), SweepError> {
    let mut next = tally.rows;
    let mut pieces = || {
        let piece = next..total.min(next + length().max(1));
        next = piece.end;
        (!piece.is_empty()).then_some(piece)
    };
    let mut take = |end: u64, made: Made<T>| {
        put(made.output).map_err(Some)?;
        for count in made.counts {
            tally.push(count);
        }
        if tally.rows < end { Err(None) } else { Ok(()) }
    };
    let queue =
        Queue { pieces: &mut pieces, next: 0, taken: 0, made: BTreeMap::new(), take: Some(&mut take), failure: Ok(()) };
    let work = Work { make: &make, queue: Mutex::new(queue) };
    rayon::scope(|scope| {
        // this is the number of pieces that exist at a time, which limits the memory
        for _ in 0..2 * rayon::current_num_threads() {
            scope.spawn(|scope| work.step(scope));
        }
    });
    let failure = work.queue.into_inner().unwrap_or_else(PoisonError::into_inner).failure;
    failure.or_else(|end| end.map_or(Ok(()), Err))
}

/// Makes a piece. Fails with an error, or with `None` if the run was cancelled.
type Make<'a, T> = dyn Fn(Range<u64>) -> Result<Made<T>, Option<SweepError>> + Sync + 'a;
/// Writes a piece that ends before this row, and counts its rows.
type Take<'a, T> = dyn FnMut(u64, Made<T>) -> Result<(), Option<SweepError>> + Send + 'a;

/// Pieces that wait to be written, and the right to write them.
struct Queue<'a, T> {
    /// The rows of the next piece; `None` at the end.
    pieces: &'a mut (dyn FnMut() -> Option<Range<u64>> + Send),
    /// Number of the next piece to be made.
    next: u64,
    /// Number of the next piece to be written.
    taken: u64,
    /// Finished pieces that wait for an earlier one, each with the row where it ends.
    made: BTreeMap<u64, (u64, Made<T>)>,
    /// Writes a piece. `None` while a thread is using it.
    take: Option<&'a mut Take<'a, T>>,
    /// The first failure; after it no more pieces are made or written.
    failure: Result<(), Option<SweepError>>,
}

struct Work<'a, T> {
    make: &'a Make<'a, T>,
    queue: Mutex<Queue<'a, T>>,
}

impl<'a, T: Send> Work<'a, T> {
    fn queue(&self) -> MutexGuard<'_, Queue<'a, T>> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes one piece. Then writes all pieces that are next in order, unless another thread is writing. Each piece
    /// written starts one more step.
    fn step<'scope>(&'scope self, scope: &Scope<'scope>) {
        let (index, piece) = {
            let mut queue = self.queue();
            if queue.failure.is_err() {
                return;
            }
            let Some(piece) = (queue.pieces)() else { return };
            queue.next += 1;
            (queue.next - 1, piece)
        };
        let end = piece.end;
        let made = (self.make)(piece);
        let mut queue = self.queue();
        match made {
            Ok(made) => drop(queue.made.insert(index, (end, made))),
            Err(error) => queue.fail(error),
        }
        let Some(take) = queue.take.take() else { return };
        while queue.failure.is_ok() {
            let next = queue.taken;
            let Some((end, made)) = queue.made.remove(&next) else { break };
            drop(queue);
            let result = take(end, made);
            queue = self.queue();
            queue.taken += 1;
            match result {
                Ok(()) => scope.spawn(|scope| self.step(scope)),
                Err(error) => queue.fail(error),
            }
        }
        queue.take = Some(take);
    }
}

impl<T> Queue<'_, T> {
    fn fail(&mut self, error: Option<SweepError>) {
        if self.failure.is_ok() {
            self.failure = Err(error);
        }
    }
}
