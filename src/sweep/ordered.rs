//! Results made on all threads and taken in order, while the next ones are being made.

use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::Scope;

/// What waits to be taken, and who may take it.
struct Queue<T, E, Take> {
    /// Number of the next result to be made.
    next: u64,
    /// Number of the next result to be taken.
    taken: u64,
    made: BTreeMap<u64, T>,
    /// Away while a thread takes.
    take: Option<Take>,
    failure: Option<E>,
}

struct Work<T, E, Make, Take> {
    count: u64,
    make: Make,
    queue: Mutex<Queue<T, E, Take>>,
}

/// Makes results 0 to `count` − 1 on the threads of the pool and takes them in this order, whichever thread is free. At
/// most two a thread are there at a time, so that memory is bounded. Ends with the first failure.
///
/// # Errors
/// Those of `make` and `take`.
pub(super) fn in_order<T, E, Make, Take>(count: u64, make: Make, take: Take) -> Result<(), E>
where
    T: Send,
    E: Send,
    Make: Fn(u64) -> Result<T, E> + Sync,
    Take: FnMut(T) -> Result<(), E> + Send,
{
    let queue = Queue { next: 0, taken: 0, made: BTreeMap::new(), take: Some(take), failure: None };
    let work = Work { count, make, queue: Mutex::new(queue) };
    rayon::scope(|scope| {
        for _ in 0..count.min(2 * rayon::current_num_threads() as u64) {
            scope.spawn(|scope| work.step(scope));
        }
    });
    let queue = work.queue.into_inner().unwrap_or_else(PoisonError::into_inner);
    queue.failure.map_or(Ok(()), Err)
}

impl<T, E, Make, Take> Work<T, E, Make, Take>
where
    T: Send,
    E: Send,
    Make: Fn(u64) -> Result<T, E> + Sync,
    Take: FnMut(T) -> Result<(), E> + Send,
{
    fn queue(&self) -> MutexGuard<'_, Queue<T, E, Take>> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes one result, and takes what is next unless another thread is at it. Every result taken makes room for a step.
    fn step<'scope>(&'scope self, scope: &Scope<'scope>) {
        let index = {
            let mut queue = self.queue();
            if queue.failure.is_some() || queue.next == self.count {
                return;
            }
            queue.next += 1;
            queue.next - 1
        };
        let made = (self.make)(index);
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
