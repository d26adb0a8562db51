//! How far a long computation is, and whether it has to stop. The computation counts and looks; whoever waits for it reads the
//! count, and asks it to stop.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// How far a computation is, in pieces of work, and whether it has to stop.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    /// All of them; 0 where that is not known.
    total: AtomicU64,
    /// Set when the result is no longer wanted.
    stop: Arc<AtomicBool>,
}

impl Progress {
    /// Nothing is done yet. The flag, which a handler of signals may set, stops the computation.
    pub fn with_stop_flag(stop: Arc<AtomicBool>) -> Self {
        Self { stop, ..Self::default() }
    }

    /// Adds pieces that are to be done.
    pub fn add_total(&self, pieces: u64) {
        self.total.fetch_add(pieces, Ordering::Relaxed);
    }

    /// Counts a piece as done.
    pub fn advance(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }

    /// Says how many are done, and how many there are.
    pub fn set(&self, done: u64, total: u64) {
        self.done.store(done, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// True if the computation has to stop. It then ends soon and gives no result.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// How many are done, and how many there are; 0 where that is not known.
    pub fn counts(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}
