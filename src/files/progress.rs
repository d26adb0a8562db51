//! Progress of a long computation, and its stop flag. The computation counts its work and reads the flag. The caller reads the count
//! and sets the flag.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Progress of a computation in units of work, and its stop flag.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    /// The total; 0 if it is not known.
    total: AtomicU64,
    /// Set to stop the computation.
    stop: Arc<AtomicBool>,
}

impl Progress {
    /// Nothing is done yet. The flag, which a handler of signals may set, stops the computation.
    pub fn with_stop_flag(stop: Arc<AtomicBool>) -> Self {
        Self { stop, ..Self::default() }
    }

    /// Adds units of work to the total.
    pub fn add_total(&self, pieces: u64) {
        self.total.fetch_add(pieces, Ordering::Relaxed);
    }

    /// Counts one unit of work as done.
    pub fn advance(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }

    /// Sets the number of finished units of work, and the total.
    pub fn set(&self, done: u64, total: u64) {
        self.done.store(done, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// True if the computation must stop. It then ends soon without a result.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// The number of finished units of work, and the total, which is 0 if it is not known.
    pub fn counts(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}
