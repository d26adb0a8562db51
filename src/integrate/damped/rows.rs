//! The numbers of every lane side by side, and what is done to all of them at once.

use pulp::{Simd, WithSimd};

use super::super::dop853::{self, Quad, Step};
use super::super::lanes::{Lane, Wide};
use super::super::motions::{Hertz, Mixed, Straight};
use super::Run;
use super::lockstep::LANES;
use super::run::{Limits, longer};

/// Registers in flight at once: the chain of dependent operations of one step is longer than its arithmetic.
const REGISTERS: usize = 2;

type Row = [f64; LANES];

/// Nodes, constants and steps of every lane.
#[derive(Debug, Clone)]
pub(super) struct Rows {
    pub(super) node: [Row; 4],
    pub(super) rates: [Row; 4],
    pub(super) h: Row,
    pub(super) a: Row,
    pub(super) b: Row,
    pub(super) k: Row,
    pub(super) chi: Row,
    pub(super) c: Row,
    pub(super) pull: Row,
    pub(super) is_straight: Row,
    pub(super) inverse_sizes: [Row; 3],
    pub(super) next: [Row; 4],
    pub(super) next_rates: [Row; 4],
    pub(super) fifth: Row,
    pub(super) third: Row,
    pub(super) error: Row,
    pub(super) pace: Row,
    pub(super) direction: Row,
    pub(super) end: Row,
    pub(super) lifts_off: Row,
    pub(super) rests: Row,
    /// 1 in a lane whose next step is under error control, else 0.
    pub(super) marches: Row,
    /// 1 where the step has passed nothing, and then where it has been taken for that: the lane need not be told.
    pub(super) clear: Row,
    /// Steps since the lane was told of one.
    pub(super) untold: Row,
}

impl Rows {
    /// Lanes without motions.
    pub(super) fn idle() -> Self {
        let row = [0.0; LANES];
        Self {
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
        }
    }

    /// From where a lane steps next, and how far.
    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, run: &Run) {
        for part in 0..4 {
            self.node[part][lane] = run.node[part];
            self.rates[part][lane] = run.rates[part];
        }
        self.put_length(lane, run);
    }

    #[inline(always)]
    pub(super) fn put_length(&mut self, lane: usize, run: &Run) {
        self.h[lane] = run.length;
        self.marches[lane] = f64::from(u8::from(run.is_marching()));
        self.untold[lane] = 0.0;
    }

    /// What a lane has not been told of.
    #[inline(always)]
    pub(super) fn catch_up(&self, lane: usize, run: &mut Run) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a count
        let untold = self.untold[lane] as u64;
        run.has_gone_on(at(&self.node, lane), at(&self.rates, lane), self.h[lane], untold);
    }

    #[inline(always)]
    pub(super) fn step_of(&self, lane: usize) -> Step {
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
pub(super) struct Stepping<'a, const M: u8>(pub(super) &'a mut Rows);

impl<const M: u8> WithSimd for Stepping<'_, M> {
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
pub(super) struct Onward<'a>(pub(super) &'a mut Rows);

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
