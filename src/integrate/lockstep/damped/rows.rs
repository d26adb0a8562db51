//! The numbers of all lanes side by side, and the operations on all of them at once.

use pulp::Simd;

use super::super::{At, Kernel, Row, of_lane, put};
use crate::integrate::Drag;
use crate::integrate::damped::run::{Limits, Run, longer};
use crate::integrate::dop853::{self, Step};
use crate::integrate::lanes::Lane;
use crate::integrate::piece::mixed::DraggedMixed;
use crate::integrate::piece::power::DraggedHertz;
use crate::integrate::piece::straight::DraggedStraight;

/// Nodes, constants and steps of every lane.
#[derive(Debug, Clone, Default)]
#[repr(align(64))] // no register is read across two lines of the cache
pub(super) struct Rows {
    pub(super) node: [Row; 4],
    pub(super) rates: [Row; 4],
    pub(super) h: Row,
    /// a and b of a straight piece, k of a Hertz piece, and 1 on a straight piece or 0 on a Hertz piece.
    pub(super) piece: [Row; 4],
    /// The parts of [`Drag`].
    pub(super) drag: [Row; 2],
    pub(super) pull: Row,
    pub(super) inverse_sizes: [Row; 3],
    pub(super) next: [Row; 4],
    pub(super) next_rates: [Row; 4],
    pub(super) fifth: Row,
    pub(super) third: Row,
    pub(super) error: Row,
    pub(super) pace: Row,
    /// The parts of [`Limits`].
    pub(super) limits: [Row; 4],
    /// 1 in a lane whose next step is under error control, else 0.
    pub(super) marches: Row,
    /// 1 if no event lies in the step. After [`Onward`] it is 1 only if the step was also accepted; the [`Run`] of the lane is
    /// then not needed.
    pub(super) clear: Row,
    /// Steps that the [`Run`] of the lane has not counted yet.
    pub(super) untold: Row,
}

impl Rows {
    /// Sets the node of a lane and the length of its next step.
    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, run: &Run) {
        put(&mut self.node, lane, run.node);
        put(&mut self.rates, lane, run.rates);
        self.put_length(lane, run);
    }

    /// Sets the length alone. Numbers that are written one by one are slow to be read as a row, so an equal length is not
    /// written again.
    #[inline(always)]
    pub(super) fn put_length(&mut self, lane: usize, run: &Run) {
        self.h[lane] = run.length;
        self.marches[lane] = f64::from(u8::from(run.is_marching()));
        self.untold[lane] = 0.0;
    }

    /// Steps of a lane that its [`Run`] has not counted yet.
    #[inline(always)]
    pub(super) fn catch_up(&self, lane: usize, run: &mut Run) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a count
        let untold = self.untold[lane] as u64;
        run.has_gone_on(of_lane(&self.node, lane), of_lane(&self.rates, lane), self.h[lane], untold);
    }

    #[inline(always)]
    pub(super) fn step_of(&self, lane: usize) -> Step {
        let (node, rates) = (of_lane(&self.next, lane), of_lane(&self.next_rates, lane));
        Step { node, rates, fifth: self.fifth[lane], third: self.third[lane] }
    }
}

/// One step of all lanes.
pub(super) struct Stepping<'a, const M: u8>(pub(super) &'a mut Rows);

impl<const M: u8> Kernel for Stepping<'_, M> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, at: At<S>) {
        let rows = &mut *self.0;
        let ([chi, eta], pull) = (at.load_all(&rows.drag), at.load(&rows.pull));
        let drag = Drag { chi, eta };
        let [a, b, k, is_straight] = at.load_all(&rows.piece);
        let (straight, hertz) = (DraggedStraight { a, b, drag, pull }, DraggedHertz::<M, _> { k, drag, pull });
        let motion = DraggedMixed { straight, hertz, is_straight };
        let (node, rates) = (at.load_all(&rows.node), at.load_all(&rows.rates));
        let next = dop853::step(motion, &node, &rates, at.load(&rows.h), &at.load_all(&rows.inverse_sizes));
        let [direction, end, lifts_off, rests] = at.load_all(&rows.limits);
        let limits = Limits { direction, end, lifts_off, rests };
        let is_clear = limits.is_clear(&next, motion.contact(&node, &rates), motion.contact(&next.node, &next.rates));
        at.store(is_clear * at.load(&rows.marches), &mut rows.clear);
        at.store_all(next.node, &mut rows.next);
        at.store_all(next.rates, &mut rows.next_rates);
        at.store(next.fifth, &mut rows.fifth);
        at.store(next.third, &mut rows.third);
    }
}

/// Takes the steps that are accepted and have passed no event.
pub(super) struct Onward<'a>(pub(super) &'a mut Rows);

impl Kernel for Onward<'_> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, at: At<S>) {
        let rows = &mut *self.0;
        let h = at.load(&rows.h);
        let (zero, one) = (h.all(0.0), h.all(1.0));
        let goes_on = at.load(&rows.error).if_less(one, at.load(&rows.clear), zero);
        for part in 0..4 {
            let node = zero.if_less(goes_on, at.load(&rows.next[part]), at.load(&rows.node[part]));
            let rates = zero.if_less(goes_on, at.load(&rows.next_rates[part]), at.load(&rows.rates[part]));
            at.store(node, &mut rows.node[part]);
            at.store(rates, &mut rows.rates[part]);
        }
        let length = zero.if_less(goes_on, longer(h, at.load(&rows.pace)), h);
        at.store(length, &mut rows.h);
        at.store(at.load(&rows.untold) + goes_on, &mut rows.untold);
        at.store(goes_on, &mut rows.clear);
    }
}
