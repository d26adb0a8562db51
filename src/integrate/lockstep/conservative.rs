//! Lanes of rk8 without drag and pull, on straight and Hertz pieces. Tables use them with `method = "rk8"` only: the closed
//! forms are 4 to 10 times faster.

use pulp::{Arch, Simd};

use super::{AllLanes, At, Ended, Kernel, LANES, Lanes, Row, Started, of_lane, put};
use crate::integrate::landing::{AT_END, Node, Target};
use crate::integrate::lanes::Lane;
use crate::integrate::piece::mixed::Mixed;
use crate::integrate::piece::power::Power;
use crate::integrate::piece::straight::Straight;
use crate::integrate::rk8::{Constants, Rk8, grown, shrunk};
use crate::integrate::{Drag, Integrator as _, Landing, MOST_STEPS, Path, Restoring, State};

/// Every so many common steps, lanes are checked for states that are not finite and for legs without end.
const LOOK: u64 = 1024;

/// The state and the constants of every lane.
#[derive(Debug, Clone, Default)]
#[repr(align(64))] // no register is read across two lines of the cache
struct Rows {
    /// y, u, g, t.
    node: [Row; 4],
    h: Row,
    /// The parts of [`Mixed`].
    field: [Row; 4],
    /// The parts of [`Target`], and then the others of [`Constants`].
    leg: [Row; 8],
    /// 0 on the way, else the kind of landing.
    landed: Row,
}

/// The lanes.
#[derive(Debug, Clone)]
pub struct Conservative {
    rows: Box<Rows>,
    /// Of every lane that is not idle: the common step before which its leg began.
    begun: [Option<u64>; LANES],
    rk8: Rk8,
    /// Steps of all lanes so far.
    steps: u64,
    arch: Arch,
}

impl Conservative {
    /// Lanes of this relative tolerance, all idle.
    pub fn new(tolerance: f64) -> Self {
        let rows = Rows { h: [1.0; LANES], ..Rows::default() };
        Self { rows: Box::new(rows), begun: [None; LANES], rk8: Rk8::new(tolerance), steps: 0, arch: Arch::new() }
    }
}

impl Lanes for Conservative {
    fn start(&mut self, lane: usize, path: &Path, at: &mut State) -> Started {
        if path.pull != 0.0 || path.drag != Drag::NONE {
            return Started::Foreign;
        }
        let rows = &mut *self.rows;
        let (field, (leg, node, h)) = match path.restoring {
            Restoring::Straight { at_start: a, slope: b } => {
                ([a, b, 0.0, 1.0], self.rk8.begin(Straight::<false>::new(a, b, 0.0), path, at))
            }
            Restoring::Power { coefficient, exponent: 1.5 } => {
                let hertz = Power::<true, false>::new(coefficient, 1.5, 0.0);
                ([0.0, 0.0, hertz.c, 0.0], self.rk8.begin(hertz, path, at))
            }
            Restoring::Power { .. } | Restoring::Smooth { .. } => return Started::Foreign,
        };
        put(&mut rows.field, lane, field);
        put(&mut rows.node, lane, [node.y, node.u, node.g, node.t]);
        rows.h[lane] = h;
        let Target { end, y, u, g, direction } = leg.target;
        put(&mut rows.leg, lane, [end, y, u, g, direction, leg.inverse_y, leg.inverse_u, leg.left_out_squared]);
        self.begun[lane] = Some(self.steps);
        Started::UnderWay
    }

    #[inline]
    fn step(&mut self) -> bool {
        self.arch.dispatch(AllLanes(Stepping(&mut self.rows)));
        self.steps += 1;
        self.steps.is_multiple_of(LOOK) || self.rows.landed.iter().any(|landed| *landed != 0.0)
    }

    #[inline]
    fn take_landing(&mut self, lane: usize, path: &Path, at: &mut State) -> Option<Ended> {
        let rows = &*self.rows;
        if rows.landed[lane] == 0.0 {
            if !self.steps.is_multiple_of(LOOK) {
                return None;
            }
            let [y, u, _, t] = of_lane(&rows.node, lane);
            let is_number = [y, u, t, rows.h[lane]].iter().all(|part| part.is_finite());
            self.begun[lane].take_if(|begun| !is_number || self.steps - *begun >= MOST_STEPS)?;
            // integrated alone, the leg gives the error, or does not fail
            return Some(self.rk8.traverse(path, at, None));
        }
        self.begun[lane].take()?;
        let [y, u, _, t] = of_lane(&rows.node, lane);
        let landing = if rows.landed[lane] == AT_END { Landing::End } else { Landing::Turning };
        let is_straight = rows.field[3][lane] > 0.0;
        at.distance = path.landed_at(landing, if is_straight { y } else { y * y });
        (at.time, at.speed) = (t, u);
        Some(Ok(landing))
    }
}

/// One step of all lanes.
struct Stepping<'a>(&'a mut Rows);

impl Kernel for Stepping<'_> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, at: At<S>) {
        let rows = &mut *self.0;
        let [y, u, g, t] = at.load_all(&rows.node);
        let [a, b, c, is_straight] = at.load_all(&rows.field);
        let [end, target_y, target_u, target_g, direction, inverse_y, inverse_u, left_out_squared] =
            at.load_all(&rows.leg);
        let target = Target { end, y: target_y, u: target_u, g: target_g, direction };
        let leg = Constants { target, inverse_y, inverse_u, left_out_squared };
        let field = Mixed { a, b, c, is_straight };
        let (node, next_h, kind) = step(field, &leg, &Node { y, u, g, t }, at.load(&rows.h));
        at.store_all([node.y, node.u, node.g, node.t], &mut rows.node);
        at.store(next_h, &mut rows.h);
        at.store(kind, &mut rows.landed);
    }
}

/// One pass of the loop of rk8, with choices instead of branches. Returns the next node, the next step, the kind of landing.
#[inline(always)]
fn step<T: Lane>(field: Mixed<T>, leg: &Constants<T>, now: &Node<T>, h: T) -> (Node<T>, T, T) {
    let zero = h.all(0.0);
    let one = h.all(1.0);
    let reach = leg.target.reach(now, h);
    let gap = (leg.target.y - now.y).abs();
    let (limited, last) = leg.target.limit(now, h);
    let this = reach.if_less(gap, h, limited);
    let may_land = reach.if_less(gap, zero, h.if_less(last, zero, one));

    let (stepped, error) = leg.step(field, now, this);
    let landed = leg.target.land(field, &stepped);
    let is_rejected = one.if_less(error, one, zero);
    let is_mended = landed.left_out_squared.if_less(leg.left_out_squared, may_land, zero);
    let lands = zero.if_less(is_rejected, zero, is_mended);

    macro_rules! pick {
        ($part:ident) => {
            zero.if_less(is_rejected, now.$part, zero.if_less(lands, landed.node.$part, stepped.$part))
        };
    }
    let node = Node { y: pick!(y), u: pick!(u), g: pick!(g), t: pick!(t) };
    let next = zero.if_less(is_rejected, shrunk(this, error), grown(this, error));
    (node, next, zero.if_less(lands, landed.kind, zero))
}
