//! How far a long computation is: counted by whoever computes, looked at by whoever waits.

use std::sync::atomic::{AtomicU64, Ordering};

/// How far a computation is, in pieces of work.
#[derive(Debug, Default)]
pub struct Counter {
    /// Pieces that are done.
    done: AtomicU64,
    /// All of them; 0 where that is not known.
    total: AtomicU64,
}

impl Counter {
    /// There are so many pieces more.
    pub fn expect(&self, pieces: u64) {
        self.total.fetch_add(pieces, Ordering::Relaxed);
    }

    /// One more is done.
    pub fn step(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }

    /// How many are done, and how many there are; 0 where that is not known.
    pub fn read(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}
