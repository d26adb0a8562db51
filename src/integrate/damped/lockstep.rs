//! The damped stepper for many motions at once: every lane has its own piece, state and step size, and all of them step
//! together.
//!
//! A step is that of [`super::super::dop853`] on registers of whatever width the machine has (chosen at run time); what
//! comes of it, each lane is told by itself as the stepper alone is. So a lane gives the same bits as the stepper.

use pulp::{Arch, Simd, WithSimd};

use super::super::dop853::{self, Quad, Step};
use super::super::forced::{Drag, ForcedLanding, ForcedPath, ForcedState};
use super::super::lanes::Wide;
use super::super::motions::{Hertz, Mixed, Straight};
use super::super::{IntegrationError, Restoring};
use super::{Progress, Run, Verdict};

/// Motions that step together.
pub const LANES: usize = 32;

/// Registers in flight at once: the chain of dependent operations of one step is longer than its arithmetic.
const REGISTERS: usize = 2;

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
        };
        Self { rows: Box::new(rows), ways: Box::new([None; LANES]), tolerance, arch: Arch::new() }
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
        self.ways[lane] = Some((run, piece));
        Started::UnderWay
    }

    /// One step in every lane. Each lane that is under way is to be told then.
    pub fn step(&mut self) {
        let rows = &mut *self.rows;
        self.arch.dispatch(Kernel::<M>(rows));
        // in loops of their own, so that the slow functions of one lane overlap those of the next
        for lane in 0..LANES {
            rows.error[lane] = rows.step_of(lane).error(rows.h[lane]);
        }
        for lane in 0..LANES {
            rows.pace[lane] = Verdict::pace(rows.error[lane]);
        }
    }

    /// Tells a lane what the last step has come to. If its leg has ended, the lane is then idle.
    #[inline]
    pub fn tell(&mut self, lane: usize) -> Option<Landed> {
        let rows = &mut *self.rows;
        let (run, piece) = self.ways[lane].as_mut()?;
        let next = rows.step_of(lane);
        let verdict = Verdict { error: rows.error[lane], pace: rows.pace[lane] };
        let told = match piece {
            Piece::Straight(piece) => run.tell(*piece, &next, verdict),
            Piece::Hertz(piece) => run.tell(*piece, &next, verdict),
        };
        let landed = match told {
            Ok(Progress::Again) => {
                rows.h[lane] = run.length;
                return None;
            }
            Ok(Progress::Moved { .. }) => {
                rows.put(lane, run);
                return None;
            }
            Ok(Progress::Landed { landing, state, .. }) => Ok((landing, state)),
            Err(error) => Err(error),
        };
        self.ways[lane] = None;
        Some(landed)
    }

    /// Takes the rest of a leg out of its lane and goes it alone.
    pub fn finish(&mut self, lane: usize) -> Option<Landed> {
        let (mut run, piece) = self.ways[lane].take()?;
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
        self.h[lane] = run.length;
    }

    #[inline(always)]
    fn step_of(&self, lane: usize) -> Step {
        let of = |rows: &[Row; 4]| -> Quad { [rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane]] };
        Step { node: of(&self.next), rates: of(&self.next_rates), fifth: self.fifth[lane], third: self.third[lane] }
    }
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
            macro_rules! load {
                ($row:expr) => {
                    Wide::<S, REGISTERS>::load(simd, &S::as_simd_f64s(&$row).0[first..])
                };
            }
            macro_rules! load4 {
                ($rows:expr) => {
                    [load!($rows[0]), load!($rows[1]), load!($rows[2]), load!($rows[3])]
                };
            }
            let (chi, c, pull) = (load!(rows.chi), load!(rows.c), load!(rows.pull));
            let motion = Mixed {
                straight: Straight { a: load!(rows.a), b: load!(rows.b), chi, c, pull },
                hertz: Hertz::<M, _> { k: load!(rows.k), chi, c, pull },
                is_straight: load!(rows.is_straight),
            };
            let sizes = [load!(rows.inverse_sizes[0]), load!(rows.inverse_sizes[1]), load!(rows.inverse_sizes[2])];
            let next = dop853::step(motion, &load4!(rows.node), &load4!(rows.rates), load!(rows.h), &sizes);
            for part in 0..4 {
                next.node[part].store(&mut S::as_mut_simd_f64s(&mut rows.next[part]).0[first..]);
                next.rates[part].store(&mut S::as_mut_simd_f64s(&mut rows.next_rates[part]).0[first..]);
            }
            next.fifth.store(&mut S::as_mut_simd_f64s(&mut rows.fifth).0[first..]);
            next.third.store(&mut S::as_mut_simd_f64s(&mut rows.third).0[first..]);
            first += REGISTERS;
        }
    }
}
