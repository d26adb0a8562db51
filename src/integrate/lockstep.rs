//! Many motions at once: every lane has its own piece, state and step size, and all of them step together.
//!
//! The formulas are those of the steppers, evaluated on registers of whatever width the machine has (chosen at run time), so
//! a lane gives the same bits as the stepper by itself.

pub mod conservative;
pub mod damped;

use super::{IntegrationError, Landing, Path, State};

/// Motions that step together.
pub const LANES: usize = 32;

/// Registers in flight at once: the chain of dependent operations of one step is longer than its arithmetic.
const REGISTERS: usize = 2;

/// One number of every lane.
type Row = [f64; LANES];

/// How a leg starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Started {
    /// It is on its way.
    UnderWay,
    /// It has ended where it began.
    Landed(Landing, State),
    /// It is none that these lanes can do.
    Foreign,
}

/// What a leg comes to.
pub type Landed = Result<(Landing, State), IntegrationError>;

/// Lanes of one stepper.
pub trait Lanes {
    /// So few motions under way are done faster one by one.
    const FEW: usize;

    /// Puts a leg into a lane.
    #[must_use]
    fn start(&mut self, lane: usize, path: &Path, state: &State) -> Started;

    /// One step, accepted or rejected, in every lane. Whether any lane may have landed: they are to be asked then.
    #[must_use]
    fn step(&mut self) -> bool;

    /// What the leg of a lane has come to, if the last step has ended it; the lane is then idle. It was started along this
    /// path from the state `begun`.
    fn take_landing(&mut self, lane: usize, path: &Path, begun: &State) -> Option<Landed>;

    /// Takes the rest of a leg out of its lane and goes it alone; `None` in a lane that is idle.
    fn finish(&mut self, lane: usize, path: &Path, begun: &State) -> Option<Landed>;
}

/// The registers of a row from `$first` on.
macro_rules! load {
    ($row:expr, $simd:ident, $first:ident) => {
        $crate::integrate::lanes::Wide::<S, { $crate::integrate::lockstep::REGISTERS }>::load(
            $simd,
            &S::as_simd_f64s(&$row).0[$first..],
        )
    };
}
macro_rules! store {
    ($value:expr, $row:expr, $first:ident) => {
        $value.store(&mut S::as_mut_simd_f64s(&mut $row).0[$first..])
    };
}
use {load, store};
