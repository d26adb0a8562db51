//! Pieces of a table made on all threads and put in order, while the next ones are being made.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::Scope;

use super::SweepError;
use super::count::Count;
use super::sidecar::Tally;

/// Rows that were made together.
pub(super) struct Made<T> {
    /// What is written of them.
    pub(super) output: T,
    /// How each of them counts.
    pub(super) counts: Vec<Count>,
}

/// Makes the rows after those of `tally`, up to `total`, and counts those that were put. A piece has as many rows as
/// `length` says when it is begun. Where `make` gives fewer, or fails with `None`, the rows are stopped: what comes behind is
/// neither put nor counted. The pieces are made on the threads of the pool and put in their order, whichever thread is free.
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
        // so many pieces are there at a time, which bounds the memory
        for _ in 0..2 * rayon::current_num_threads() {
            scope.spawn(|scope| work.step(scope));
        }
    });
    let failure = work.queue.into_inner().unwrap_or_else(PoisonError::into_inner).failure;
    failure.or_else(|end| end.map_or(Ok(()), Err))
}

/// What makes a piece, and why there is none: an error, or `None` where the rows were stopped.
type Make<'a, T> = dyn Fn(Range<u64>) -> Result<Made<T>, Option<SweepError>> + Sync + 'a;
/// What takes a piece, up to this row.
type Take<'a, T> = dyn FnMut(u64, Made<T>) -> Result<(), Option<SweepError>> + Send + 'a;

/// What waits to be taken, and who may take it.
struct Queue<'a, T> {
    /// Gives the next piece.
    pieces: &'a mut (dyn FnMut() -> Option<Range<u64>> + Send),
    /// Number of the next piece to be made.
    next: u64,
    /// Number of the next piece to be taken.
    taken: u64,
    /// Pieces that wait for the one before them, with the row where each ends.
    made: BTreeMap<u64, (u64, Made<T>)>,
    /// Not here while a thread takes.
    take: Option<&'a mut Take<'a, T>>,
    /// The first failure, which ends it all.
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

    /// Makes one piece, and takes what is next unless another thread does. Every piece taken makes room for a step.
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
