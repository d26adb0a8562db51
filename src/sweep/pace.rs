//! How many rows a thread computes at a time. Between two pieces the thread checks for cancellation and reports
//! progress.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Rows of the first piece: few, because a row may take long.
const FIRST: u64 = 4;
/// Rows of the longest piece. It is long because each piece has a cost of its own.
pub const LONGEST: u64 = 4096;
/// A piece that takes less time than this is followed by a longer one.
const SHORT: Duration = Duration::from_millis(5);
/// A piece that takes more time than this is followed by a shorter one.
const LONG: Duration = Duration::from_millis(50);

/// The pace of all threads of a table.
pub struct Pace<'a> {
    is_cancelled: &'a AtomicBool,
    report: &'a (dyn Fn(u64) + Sync),
    /// Rows of the next piece.
    piece: AtomicU64,
    /// Rows computed.
    done: AtomicU64,
}

impl<'a> Pace<'a> {
    /// Stops when `is_cancelled` is set, and calls `report` with the number of rows computed.
    pub fn new(is_cancelled: &'a AtomicBool, report: &'a (dyn Fn(u64) + Sync)) -> Self {
        Self { is_cancelled, report, piece: AtomicU64::new(FIRST), done: AtomicU64::new(0) }
    }

    /// How many rows a thread computes next.
    pub fn piece(&self) -> u64 {
        self.piece.load(Ordering::Relaxed)
    }

    /// Calls `compute` with piece after piece of the rows. Returns false if it was cancelled before all rows were done.
    pub fn walk(&self, rows: Range<u64>, mut compute: impl FnMut(Range<u64>)) -> bool {
        let mut next = rows.start;
        while next < rows.end {
            if self.is_cancelled.load(Ordering::Relaxed) {
                return false;
            }
            let piece = self.piece();
            let end = rows.end.min(next + piece);
            let begun = Instant::now();
            compute(next..end);
            let took = begun.elapsed();
            if took < SHORT && end - next == piece && piece < LONGEST {
                self.piece.store(piece * 2, Ordering::Relaxed);
            } else if took > LONG {
                self.piece.store(((end - next) / 2).max(1), Ordering::Relaxed);
            }
            let done = self.done.fetch_add(end - next, Ordering::Relaxed) + end - next;
            (self.report)(done);
            next = end;
        }
        true
    }
}
