//! How many rows a thread computes at a time. Between two pieces it looks whether it is to stop, and reports its progress.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Rows of the first piece: few, because they may be slow.
const FIRST: u64 = 4;
/// Rows of the longest piece: many against what it costs to begin one. In lock step every piece ends with idle lanes.
pub const LONGEST: u64 = 4096;
/// How long a piece is to take, at least and at most.
const SHORT: Duration = Duration::from_millis(5);
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
    /// Stops when `is_cancelled` is set; tells `report` how many rows are computed.
    pub fn new(is_cancelled: &'a AtomicBool, report: &'a (dyn Fn(u64) + Sync)) -> Self {
        Self { is_cancelled, report, piece: AtomicU64::new(FIRST), done: AtomicU64::new(0) }
    }

    /// How many rows a thread computes next.
    pub fn piece(&self) -> u64 {
        self.piece.load(Ordering::Relaxed)
    }

    /// Calls `compute` with piece after piece of the rows, until they are done or it is cancelled; which of both.
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
