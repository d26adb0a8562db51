//! Computations for Python. Many values are computed on threads of the module, where Ctrl-C stops them; few values are computed in
//! the calling thread. Meanwhile the interpreter is free.

use std::mem;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use pyo3::exceptions::{PyMemoryError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::files::Progress;
use crate::table::chunks::ordered_parallel;

/// Number of rows that a thread computes at a time: of usual rows, and of slow ones. Ctrl-C stops a computation between them.
const CHUNK_ROWS: [usize; 2] = [1024, 16];
/// With so few rows the calling thread is done before another has begun.
const MAX_INLINE_ROWS: usize = 1000;
/// Time between two checks for signals.
const POLL_INTERVAL: Duration = Duration::from_millis(50);

/// The thread pool and the id of its process. A process made by `fork` does not have the threads of its parent, and
/// gets a pool of its own.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

fn pool() -> PyResult<Arc<ThreadPool>> {
    let mut slot = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    if let Some((owner, pool)) = slot.as_ref()
        && *owner == process
    {
        return Ok(Arc::clone(pool));
    }
    let pool = ThreadPoolBuilder::new().build().map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    let pool = Arc::new(pool);
    // a pool of the parent process is not dropped: dropping waits for its threads, which do not exist in this process
    mem::forget(slot.replace((process, Arc::clone(&pool))));
    Ok(pool)
}

/// Runs `work` and returns its result. When Python receives a signal such as Ctrl-C, the counter given to `work` asks it to
/// stop.
pub fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Progress) -> T + Send) -> PyResult<T> {
    let pool = py.detach(pool)?;
    let progress = Progress::default();
    let (sender, receiver) = channel();
    let receiver = Mutex::new(receiver);
    pool.in_place_scope(|scope| {
        let counter = &progress;
        scope.spawn(move |_| {
            let done = catch_unwind(AssertUnwindSafe(|| work(counter)));
            drop(done.map(|done| sender.send(done)));
        });
        loop {
            let waited =
                py.detach(|| receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(POLL_INTERVAL));
            match waited {
                Ok(done) => return Ok(done),
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(signal) = py.check_signals() {
                        progress.stop();
                        return Err(signal);
                    }
                }
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("an error inside of plm_impact; please report it"));
                }
            }
        }
    })
}

/// Columns of `rows` rows, made piece by piece; `widths` holds how many numbers each column has for a row. Few rows are
/// computed in the calling thread, unless a single one may take long (`is_slow`).
///
/// # Errors
/// `MemoryError` for columns that do not fit into memory, and `ValueError` with the first error of `make`.
pub fn columns(
    py: Python<'_>,
    rows: usize,
    widths: &[usize],
    is_slow: bool,
    make: impl Fn(Range<usize>) -> Result<Vec<Vec<f64>>, String> + Sync + Send,
) -> PyResult<Vec<Vec<f64>>> {
    if rows == 0 || rows <= MAX_INLINE_ROWS && !is_slow {
        return py.detach(|| make(0..rows)).map_err(PyValueError::new_err);
    }
    let mut columns = with_capacity(rows, widths)?;
    let together = CHUNK_ROWS[usize::from(is_slow)];
    let pieces = (0..rows).step_by(together).map(|start| start..rows.min(start + together));
    let done = interruptible(py, |progress| {
        let make = |piece| if progress.is_stopped() { Err(String::new()) } else { make(piece) };
        ordered_parallel(pieces, make, |made| {
            append(&mut columns, made);
            Ok(())
        })
    })?;
    done.map(|()| columns).map_err(PyValueError::new_err)
}

/// Empty columns with memory for `rows` rows; see [`columns`].
pub fn with_capacity(rows: usize, widths: &[usize]) -> PyResult<Vec<Vec<f64>>> {
    let reserved = |width: usize| {
        let mut column = Vec::new();
        column.try_reserve_exact(rows.saturating_mul(width)).map(|()| column)
    };
    // all of them at once first: the system may promise more memory than there is, but not in one piece
    let columns = reserved(widths.iter().sum()).and_then(|_| widths.iter().map(|width| reserved(*width)).collect());
    columns.map_err(|_| PyMemoryError::new_err(format!("a table of {rows} rows does not fit into memory; divide it")))
}

/// Appends a piece of every column.
pub fn append(columns: &mut [Vec<f64>], piece: Vec<Vec<f64>>) {
    columns.iter_mut().zip(piece).for_each(|(column, part)| column.extend(part));
}
