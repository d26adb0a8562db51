//! The damped stepper for many motions at once: every lane has its own piece, state and step size, and all of them step
//! together.
//!
//! A step is that of `dop853` on registers of whatever width the machine has (chosen at run time); what
//! comes of it, each lane is told by itself as the stepper alone is. So a lane gives the same bits as the stepper.

use pulp::Arch;

use super::super::forced::{Drag, ForcedLanding, ForcedPath, ForcedState};
use super::super::motions::{Hertz, Straight};
use super::super::{IntegrationError, Restoring};
use super::rows::{Onward, Rows, Stepping};
use super::run::least_share;
use super::{Progress, Run, Verdict};

/// Motions that step together.
pub const LANES: usize = 32;

/// A lane is told of one step in so many, even if nothing happens: it may have taken more than any leg needs.
const MOST_UNTOLD: u64 = 1024;

/// The piece that a lane is on.
#[derive(Debug, Clone, Copy)]
enum Piece<const M: u8> {
    Straight(Straight),
    Hertz(Hertz<M>),
}

/// Lanes of the damped stepper, on straight and Hertz pieces: m = 2 with drag of the force, m = 4 with drag of the stiffness.
#[derive(Debug, Clone)]
pub struct Lockstep<const M: u8> {
    rows: Box<Rows>,
    ways: Box<[Option<(Run, Piece<M>)>; LANES]>,
    tolerance: f64,
    least: f64,
    /// Steps of all lanes so far.
    steps: u64,
    arch: Arch,
}

/// How a leg starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Started {
    /// It is on its way.
    UnderWay,
    /// It has ended where it began.
    Landed(ForcedLanding, ForcedState),
    /// It is none that these lanes can do.
    Foreign,
}

/// What a leg comes to.
pub type Landed = Result<(ForcedLanding, ForcedState), IntegrationError>;

impl<const M: u8> Lockstep<M> {
    /// Lanes of this relative tolerance, all idle.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        let (rows, ways) = (Box::new(Rows::idle()), Box::new([None; LANES]));
        Self { rows, ways, tolerance, least: least_share(tolerance), steps: 0, arch: Arch::new() }
    }

    /// Whether these are the lanes for this drag.
    #[must_use]
    pub fn fits(drag: Drag) -> bool {
        let (chi, eta) = drag.coefficients();
        if M == 2 { chi != 0.0 && eta == 0.0 } else { eta != 0.0 }
    }

    /// Puts a leg into a lane.
    #[must_use]
    pub fn start(&mut self, lane: usize, path: &ForcedPath, state: &ForcedState) -> Started {
        if !Self::fits(path.drag) {
            return Started::Foreign;
        }
        let rows = &mut *self.rows;
        let (run, piece) = match path.path.restoring {
            Restoring::Straight { at_start, slope } => {
                let piece = Straight::along(at_start, slope, path);
                (rows.a[lane], rows.b[lane], rows.k[lane], rows.is_straight[lane]) = (piece.a, piece.b, 0.0, 1.0);
                (rows.chi[lane], rows.c[lane], rows.pull[lane]) = (piece.chi, piece.c, piece.pull);
                (Run::begin(piece, path, state, self.tolerance), Piece::Straight(piece))
            }
            Restoring::Power { coefficient, exponent: 1.5 } => {
                let piece = Hertz::<M>::along(coefficient, path);
                (rows.a[lane], rows.b[lane], rows.k[lane], rows.is_straight[lane]) = (0.0, 0.0, piece.k, 0.0);
                (rows.chi[lane], rows.c[lane], rows.pull[lane]) = (piece.chi, piece.c, piece.pull);
                (Run::begin(piece, path, state, self.tolerance), Piece::Hertz(piece))
            }
            Restoring::Power { .. } | Restoring::Smooth { .. } => return Started::Foreign,
        };
        let Some(run) = run else {
            return Started::Landed(ForcedLanding::Turning, super::turned(*state));
        };
        rows.put(lane, &run);
        for (row, size) in rows.inverse_sizes.iter_mut().zip(run.inverse_sizes) {
            row[lane] = size;
        }
        let limits = run.limits();
        (rows.direction[lane], rows.end[lane]) = (limits.direction, limits.end);
        (rows.lifts_off[lane], rows.rests[lane]) = (limits.lifts_off, limits.rests);
        self.ways[lane] = Some((run, piece));
        Started::UnderWay
    }

    /// One step in every lane. Each lane that is under way is to be told then.
    pub fn step(&mut self) {
        let rows = &mut *self.rows;
        self.arch.dispatch(Stepping::<M>(rows));
        // the slow functions in loops of their own, so that those of one lane overlap those of the next
        let mut marching = [0; LANES];
        let mut count = 0;
        for lane in 0..LANES {
            marching[count] = lane;
            count += usize::from(rows.marches[lane] > 0.0);
        }
        for lane in &marching[..count] {
            rows.error[*lane] = rows.step_of(*lane).error(rows.h[*lane], self.least);
        }
        for lane in &marching[..count] {
            rows.pace[*lane] = Verdict::pace(rows.error[*lane]);
        }
        self.steps += 1;
        if self.steps.is_multiple_of(MOST_UNTOLD) {
            rows.clear = [0.0; LANES];
        } else {
            self.arch.dispatch(Onward(rows));
        }
    }

    /// Tells a lane what the last step has come to. If its leg has ended, the lane is then idle.
    #[inline]
    pub fn tell(&mut self, lane: usize) -> Option<Landed> {
        let rows = &mut *self.rows;
        if rows.clear[lane] > 0.0 {
            return None;
        }
        let (run, piece) = self.ways[lane].as_mut()?;
        rows.catch_up(lane, run);
        let next = rows.step_of(lane);
        let verdict = Verdict { error: rows.error[lane], pace: rows.pace[lane] };
        let told = match piece {
            Piece::Straight(piece) => run.tell(*piece, &next, verdict),
            Piece::Hertz(piece) => run.tell(*piece, &next, verdict),
        };
        let landed = match told {
            Ok(Progress::Again) => {
                rows.put_length(lane, run);
                return None;
            }
            Ok(Progress::Moved { .. }) => {
                rows.put(lane, run);
                return None;
            }
            Ok(Progress::Landed { landing, state, .. }) => Ok((landing, state)),
            Err(error) => Err(error),
        };
        self.leave(lane);
        Some(landed)
    }

    /// Makes a lane idle.
    fn leave(&mut self, lane: usize) -> Option<(Run, Piece<M>)> {
        self.rows.marches[lane] = 0.0;
        self.ways[lane].take()
    }

    /// Takes the rest of a leg out of its lane and goes it alone.
    pub fn finish(&mut self, lane: usize) -> Option<Landed> {
        let (mut run, piece) = self.leave(lane)?;
        self.rows.catch_up(lane, &mut run);
        Some(match piece {
            Piece::Straight(piece) => super::finish(piece, &mut run, None),
            Piece::Hertz(piece) => super::finish(piece, &mut run, None),
        })
    }
}
