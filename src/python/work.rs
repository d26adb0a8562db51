//! What takes time: done by threads of the module, while the interpreter is free and Ctrl-C is heard.

use std::mem;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Numbers that a thread does at a time.
pub const TOGETHER: usize = 4096;
/// How often it is looked for signals.
const SOON: Duration = Duration::from_millis(50);

/// The threads, with the process that they belong to: a child of `fork` has none of its parent's, and gets its own.
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
    // to end threads that are not there would wait for ever
    mem::forget(slot.replace((process, Arc::clone(&pool))));
    Ok(pool)
}

/// What `work` gives. It is told to stop by the flag when Python has a signal to handle, such as that of Ctrl-C.
pub fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&AtomicBool) -> T + Send) -> PyResult<T> {
    let pool = py.detach(pool)?;
    let is_cancelled = AtomicBool::new(false);
    let (sender, receiver) = channel();
    let receiver = Mutex::new(receiver);
    pool.in_place_scope(|scope| {
        let flag = &is_cancelled;
        scope.spawn(move |_| {
            let done = catch_unwind(AssertUnwindSafe(|| work(flag)));
            drop(done.map(|done| sender.send(done)));
        });
        loop {
            let waited = py.detach(|| receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(SOON));
            match waited {
                Ok(done) => return Ok(done),
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(signal) = py.check_signals() {
                        is_cancelled.store(true, Ordering::Relaxed);
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
