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
/// neither put nor counted.
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
    let pieces = || {
        let piece = next..total.min(next + length().max(1));
        next = piece.end;
        (!piece.is_empty()).then_some(piece)
    };
    let take = |(end, made): (u64, Made<T>)| {
        put(made.output).map_err(Some)?;
        for count in made.counts {
            tally.push(count);
        }
        if tally.rows < end { Err(None) } else { Ok(()) }
    };
    in_order(pieces, |piece| Ok((piece.end, make(piece)?)), take).or_else(|end| end.map_or(Ok(()), Err))
}

/// What waits to be taken, and who may take it.
struct Queue<T, E, Pieces, Take> {
    /// Gives the next piece.
    pieces: Pieces,
    /// Number of the next piece to be made.
    next: u64,
    /// Number of the next piece to be taken.
    taken: u64,
    /// Pieces that wait for the one before them.
    made: BTreeMap<u64, T>,
    /// Not here while a thread takes.
    take: Option<Take>,
    failure: Option<E>,
}

struct Work<T, E, Pieces, Make, Take> {
    make: Make,
    queue: Mutex<Queue<T, E, Pieces, Take>>,
}

/// Makes piece after piece on the threads of the pool and takes them in this order, whichever thread is free. At most two a
/// thread are there at a time, so that memory is bounded. Ends with the first failure.
fn in_order<T, E, Pieces, Make, Take>(pieces: Pieces, make: Make, take: Take) -> Result<(), E>
where
    T: Send,
    E: Send,
    Pieces: FnMut() -> Option<Range<u64>> + Send,
    Make: Fn(Range<u64>) -> Result<T, E> + Sync,
    Take: FnMut(T) -> Result<(), E> + Send,
{
    let queue = Queue { pieces, next: 0, taken: 0, made: BTreeMap::new(), take: Some(take), failure: None };
    let work = Work { make, queue: Mutex::new(queue) };
    rayon::scope(|scope| {
        for _ in 0..2 * rayon::current_num_threads() {
            scope.spawn(|scope| work.step(scope));
        }
    });
    let queue = work.queue.into_inner().unwrap_or_else(PoisonError::into_inner);
    queue.failure.map_or(Ok(()), Err)
}

impl<T, E, Pieces, Make, Take> Work<T, E, Pieces, Make, Take>
where
    T: Send,
    E: Send,
    Pieces: FnMut() -> Option<Range<u64>> + Send,
    Make: Fn(Range<u64>) -> Result<T, E> + Sync,
    Take: FnMut(T) -> Result<(), E> + Send,
{
    fn queue(&self) -> MutexGuard<'_, Queue<T, E, Pieces, Take>> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes one piece, and takes what is next unless another thread does. Every piece taken makes room for a step.
    fn step<'scope>(&'scope self, scope: &Scope<'scope>) {
        let (index, piece) = {
            let mut queue = self.queue();
            if queue.failure.is_some() {
                return;
            }
            let Some(piece) = (queue.pieces)() else { return };
            queue.next += 1;
            (queue.next - 1, piece)
        };
        let made = (self.make)(piece);
        let mut queue = self.queue();
        match made {
            Ok(made) => drop(queue.made.insert(index, made)),
            Err(error) => drop(queue.failure.get_or_insert(error)),
        }
        let Some(mut take) = queue.take.take() else { return };
        while queue.failure.is_none() {
            let next = queue.taken;
            let Some(made) = queue.made.remove(&next) else { break };
            drop(queue);
            let result = take(made);
            queue = self.queue();
            queue.taken += 1;
            match result {
                Ok(()) => scope.spawn(|scope| self.step(scope)),
                Err(error) => drop(queue.failure.get_or_insert(error)),
            }
        }
        queue.take = Some(take);
    }
}
