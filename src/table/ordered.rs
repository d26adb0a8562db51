//! Work on all threads whose results are taken in order.

use rayon::prelude::*;

/// Pieces in memory for each thread: enough that few threads wait at the end of a round.
const PIECES: usize = 16;

/// Makes a piece of every task on all threads, and takes the pieces in the order of the tasks. While the pieces of one round
/// are taken, those of the next are made.
///
/// # Errors
/// The first error of `make` or `take`; then nothing more is begun.
pub fn in_order<T: Send, M: Send, E: Send>(
    mut tasks: impl Iterator<Item = T> + Send,
    make: impl Fn(T) -> Result<M, E> + Sync + Send,
    mut take: impl FnMut(M) -> Result<(), E> + Send,
) -> Result<(), E> {
    let mut made: Vec<Result<M, E>> = Vec::new();
    loop {
        let round: Vec<T> = tasks.by_ref().take(PIECES * rayon::current_num_threads()).collect();
        if round.is_empty() && made.is_empty() {
            return Ok(());
        }
        let ready = std::mem::take(&mut made);
        let (result, next) = rayon::join(
            || ready.into_iter().try_for_each(|piece| take(piece?)),
            || round.into_par_iter().map(&make).collect(),
        );
        result?;
        made = next;
    }
}
