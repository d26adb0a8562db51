//! Many motions at once. Every lane has its own piece, state and step size, and all lanes take their steps together.
//!
//! The formulas are those of the steppers, evaluated on registers of whatever width the machine has (chosen at run time), so
//! a lane gives the same bits as the stepper by itself.

pub mod conservative;
pub mod damped;

use pulp::{Simd, WithSimd};

use super::lanes::Wide;
use super::{IntegrationError, Landing, Path, State};

/// Motions that step together.
pub const LANES: usize = 32;

/// Registers computed side by side, because the operations of one step have to wait for each other.
const REGISTERS: usize = 2;

/// One number of every lane.
type Row = [f64; LANES];

/// How a leg starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Started {
    /// It is on its way.
    UnderWay,
    /// It has ended where it began.
    Landed(Landing),
    /// These lanes cannot do it.
    Foreign,
}

/// How a leg has ended, or why it has not.
pub type Ended = Result<Landing, IntegrationError>;

/// Lanes of one stepper.
pub trait Lanes {
    /// At most so many motions are faster one by one than in lanes.
    const FEW: usize = 0;

    /// Puts a leg that begins with this state into a lane.
    fn start(&mut self, lane: usize, path: &Path, at: &mut State) -> Started;

    /// Takes one step, accepted or rejected, in every lane. True if a lane may have landed; [`Lanes::take_landing`] is then to
    /// be called for each of them.
    fn step(&mut self) -> bool;

    /// The end of the leg of a lane, if the last step has ended it; the lane is then idle. The leg was started along this path
    /// from the state `at`, which becomes the state at its end.
    fn take_landing(&mut self, lane: usize, path: &Path, at: &mut State) -> Option<Ended>;

    /// Takes a leg out of its lane and integrates the rest of it alone; `None` for an idle lane. Only called if FEW is not 0.
    fn finish(&mut self, _lane: usize, _at: &mut State) -> Option<Ended> {
        None
    }
}

/// The numbers of one lane.
#[inline(always)]
fn of_lane<const N: usize>(rows: &[Row; N], lane: usize) -> [f64; N] {
    std::array::from_fn(|part| rows[part][lane])
}

#[inline(always)]
fn put<const N: usize>(rows: &mut [Row; N], lane: usize, numbers: [f64; N]) {
    for (row, number) in rows.iter_mut().zip(numbers) {
        row[lane] = number;
    }
}

/// What is done to the rows of all lanes, some registers of each at a time.
trait Kernel {
    fn run<S: Simd>(&mut self, at: At<S>);
}

/// A kernel on all lanes.
struct AllLanes<K>(K);

impl<K: Kernel> WithSimd for AllLanes<K> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        let mut first = 0;
        while first + REGISTERS <= LANES / S::F64_LANES {
            self.0.run(At { simd, first });
            first += REGISTERS;
        }
    }
}

/// Which registers of each row.
#[derive(Clone, Copy)]
struct At<S> {
    simd: S,
    first: usize,
}

impl<S: Simd> At<S> {
    #[inline(always)]
    fn load(self, row: &Row) -> Wide<S, REGISTERS> {
        Wide::load(self.simd, &S::as_simd_f64s(row).0[self.first..])
    }

    #[inline(always)]
    fn load_all<const N: usize>(self, rows: &[Row; N]) -> [Wide<S, REGISTERS>; N] {
        let mut loaded = [self.load(&rows[0]); N];
        for i in 1..N {
            loaded[i] = self.load(&rows[i]);
        }
        loaded
    }

    #[inline(always)]
    fn store(self, value: Wide<S, REGISTERS>, row: &mut Row) {
        value.store(&mut S::as_mut_simd_f64s(row).0[self.first..]);
    }

    #[inline(always)]
    fn store_all<const N: usize>(self, values: [Wide<S, REGISTERS>; N], rows: &mut [Row; N]) {
        for i in 0..N {
            self.store(values[i], &mut rows[i]);
        }
    }
}
