//! How far a long computation is. The computation counts; the command reads the count.

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
    /// Adds pieces that are to be done.
    pub fn expect(&self, pieces: u64) {
        self.total.fetch_add(pieces, Ordering::Relaxed);
    }

    /// Counts a piece as done.
    pub fn step(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }

    /// Says how many are done, and how many there are.
    pub fn set(&self, done: u64, total: u64) {
        self.done.store(done, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    /// How many are done, and how many there are; 0 where that is not known.
    pub fn read(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}
