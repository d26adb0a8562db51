//! The numbers of every lane side by side, and what is done to all of them at once.

use pulp::{Simd, WithSimd};

use super::super::{REGISTERS, Row, load, store};
use crate::integrate::Drag;
use crate::integrate::damped::run::{Limits, Run, longer};
use crate::integrate::dop853::{self, Step};
use crate::integrate::lanes::Lane;
use crate::integrate::piece::Quad;
use crate::integrate::piece::mixed::DraggedMixed;
use crate::integrate::piece::power::DraggedHertz;
use crate::integrate::piece::straight::DraggedStraight;

/// Nodes, constants and steps of every lane.
#[derive(Debug, Clone, Default)]
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
    /// 1 if no event lies in the step; after [`Onward`], 1 if it was also accepted, and the lane need not be told.
    pub(super) clear: Row,
    /// Steps since the lane was told of one.
    pub(super) untold: Row,
}

impl Rows {
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
            let (drag, pull) = (Drag { chi: row!(rows.chi), eta: row!(rows.c) }, row!(rows.pull));
            let motion = DraggedMixed {
                straight: DraggedStraight { a: row!(rows.a), b: row!(rows.b), drag, pull },
                hertz: DraggedHertz::<M, _> { k: row!(rows.k), drag, pull },
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
