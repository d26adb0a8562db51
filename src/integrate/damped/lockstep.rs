//! The damped stepper for many motions at once: every lane has its own piece, state and step size, and all of them step
//! together.
//!
//! A step is that of [`super::super::dop853`] on registers of whatever width the machine has (chosen at run time); what
//! comes of it, each lane is told by itself as the stepper alone is. So a lane gives the same bits as the stepper.

use pulp::{Arch, Simd, WithSimd};

use super::super::dop853::{self, Quad, Step};
use super::super::forced::{Drag, ForcedLanding, ForcedPath, ForcedState};
use super::super::lanes::{Lane, Wide};
use super::super::motions::{Hertz, Mixed, Straight};
use super::super::{IntegrationError, Restoring};
use super::run::{Limits, longer};
use super::{Progress, Run, Verdict};

/// Motions that step together.
pub const LANES: usize = 32;

/// Registers in flight at once: the chain of dependent operations of one step is longer than its arithmetic.
const REGISTERS: usize = 2;

/// A lane is told of one step in so many, even if nothing happens: it may have taken more than any leg needs.
const MOST_UNTOLD: u64 = 1024;

type Row = [f64; LANES];

/// Nodes, constants and steps of every lane.
#[derive(Debug, Clone)]
struct Rows {
    node: [Row; 4],
    rates: [Row; 4],
    h: Row,
    a: Row,
    b: Row,
    k: Row,
    chi: Row,
    c: Row,
    pull: Row,
    is_straight: Row,
    inverse_sizes: [Row; 3],
    next: [Row; 4],
    next_rates: [Row; 4],
    fifth: Row,
    third: Row,
    error: Row,
    pace: Row,
    direction: Row,
    end: Row,
    lifts_off: Row,
    rests: Row,
    /// 1 in a lane whose next step is under error control, else 0.
    marches: Row,
    /// 1 where the step has passed nothing, and then where it has been taken for that: the lane need not be told.
    clear: Row,
    /// Steps since the lane was told of one.
    untold: Row,
}

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
        let row = [0.0; LANES];
        let rows = Rows {
            node: [row; 4],
            rates: [row; 4],
            h: row,
            a: row,
            b: row,
            k: row,
            chi: row,
            c: row,
            pull: row,
            is_straight: row,
            inverse_sizes: [row; 3],
            next: [row; 4],
            next_rates: [row; 4],
            fifth: row,
            third: row,
            error: row,
            pace: row,
            direction: row,
            end: row,
            lifts_off: row,
            rests: row,
            marches: row,
            clear: row,
            untold: row,
        };
        Self { rows: Box::new(rows), ways: Box::new([None; LANES]), tolerance, steps: 0, arch: Arch::new() }
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
        self.arch.dispatch(Kernel::<M>(rows));
        // the slow functions in loops of their own, so that those of one lane overlap those of the next
        let mut marching = [0; LANES];
        let mut count = 0;
        for lane in 0..LANES {
            marching[count] = lane;
            count += usize::from(rows.marches[lane] > 0.0);
        }
        for lane in &marching[..count] {
            rows.error[*lane] = rows.step_of(*lane).error(rows.h[*lane]);
        }
        for lane in &marching[..count] {
            rows.pace[*lane] = Verdict::pace(rows.error[*lane]);
        }
        self.steps += 1;
        if self.steps % MOST_UNTOLD == 0 {
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

impl Rows {
    /// From where a lane steps next, and how far.
    #[inline(always)]
    fn put(&mut self, lane: usize, run: &Run) {
        for part in 0..4 {
            self.node[part][lane] = run.node[part];
            self.rates[part][lane] = run.rates[part];
        }
        self.put_length(lane, run);
    }

    #[inline(always)]
    fn put_length(&mut self, lane: usize, run: &Run) {
        self.h[lane] = run.length;
        self.marches[lane] = f64::from(u8::from(run.is_marching()));
        self.untold[lane] = 0.0;
    }

    /// What a lane has not been told of.
    #[inline(always)]
    fn catch_up(&self, lane: usize, run: &mut Run) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a count
        let untold = self.untold[lane] as u64;
        run.has_gone_on(at(&self.node, lane), at(&self.rates, lane), self.h[lane], untold);
    }

    #[inline(always)]
    fn step_of(&self, lane: usize) -> Step {
        let (node, rates) = (at(&self.next, lane), at(&self.next_rates, lane));
        Step { node, rates, fifth: self.fifth[lane], third: self.third[lane] }
    }
}

#[inline(always)]
fn at(rows: &[Row; 4], lane: usize) -> Quad {
    [rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane]]
}

macro_rules! load {
    ($row:expr, $simd:ident, $first:ident) => {
        Wide::<S, REGISTERS>::load($simd, &S::as_simd_f64s(&$row).0[$first..])
    };
}
macro_rules! load4 {
    ($rows:expr, $simd:ident, $first:ident) => {
        [
            load!($rows[0], $simd, $first),
            load!($rows[1], $simd, $first),
            load!($rows[2], $simd, $first),
            load!($rows[3], $simd, $first),
        ]
    };
}
macro_rules! store {
    ($value:expr, $row:expr, $first:ident) => {
        $value.store(&mut S::as_mut_simd_f64s(&mut $row).0[$first..])
    };
}

/// One step of all lanes.
struct Kernel<'a, const M: u8>(&'a mut Rows);

impl<const M: u8> WithSimd for Kernel<'_, M> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let rows = self.0;
        let mut first = 0;
        while first + REGISTERS <= S::as_simd_f64s(&rows.h).0.len() {
            macro_rules! row {
                ($row:expr) => {
                    load!($row, simd, first)
                };
            }
            let (chi, c, pull) = (row!(rows.chi), row!(rows.c), row!(rows.pull));
            let motion = Mixed {
                straight: Straight { a: row!(rows.a), b: row!(rows.b), chi, c, pull },
                hertz: Hertz::<M, _> { k: row!(rows.k), chi, c, pull },
                is_straight: row!(rows.is_straight),
            };
            let sizes = [row!(rows.inverse_sizes[0]), row!(rows.inverse_sizes[1]), row!(rows.inverse_sizes[2])];
            let (node, rates) = (load4!(rows.node, simd, first), load4!(rows.rates, simd, first));
            let next = dop853::step(motion, &node, &rates, row!(rows.h), &sizes);
            let limits = Limits {
                direction: row!(rows.direction),
                end: row!(rows.end),
                lifts_off: row!(rows.lifts_off),
                rests: row!(rows.rests),
            };
            let is_clear =
                limits.is_clear(&next, motion.contact(&node, &rates), motion.contact(&next.node, &next.rates));
            store!(is_clear * row!(rows.marches), rows.clear, first);
            for part in 0..4 {
                store!(next.node[part], rows.next[part], first);
                store!(next.rates[part], rows.next_rates[part], first);
            }
            store!(next.fifth, rows.fifth, first);
            store!(next.third, rows.third, first);
            first += REGISTERS;
        }
    }
}

/// Takes the steps that are accepted and have passed nothing.
struct Onward<'a>(&'a mut Rows);

impl WithSimd for Onward<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let rows = self.0;
        let mut first = 0;
        while first + REGISTERS <= S::as_simd_f64s(&rows.h).0.len() {
            macro_rules! row {
                ($row:expr) => {
                    load!($row, simd, first)
                };
            }
            let h = row!(rows.h);
            let (zero, one) = (h.all(0.0), h.all(1.0));
            let goes_on = row!(rows.error).if_less(one, row!(rows.clear), zero);
            for part in 0..4 {
                let node = zero.if_less(goes_on, row!(rows.next[part]), row!(rows.node[part]));
                let rates = zero.if_less(goes_on, row!(rows.next_rates[part]), row!(rows.rates[part]));
                store!(node, rows.node[part], first);
                store!(rates, rows.rates[part], first);
            }
            let length = zero.if_less(goes_on, longer(h, row!(rows.pace)), h);
            store!(length, rows.h, first);
            store!(row!(rows.untold) + goes_on, rows.untold, first);
            store!(goes_on, rows.clear, first);
            first += REGISTERS;
        }
    }
}
