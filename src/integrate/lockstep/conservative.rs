//! Lanes of rk8 without drag and pull, on straight and Hertz pieces. Tables use them with `method = "rk8"` only: the closed
//! forms are 4 to 10 times faster.

use pulp::{Arch, Simd, WithSimd};

use super::{LANES, Landed, Lanes, REGISTERS, Row, Started, load, store};
use crate::integrate::landing::{AT_END, Node, Target};
use crate::integrate::lanes::Lane;
use crate::integrate::piece::NoPull;
use crate::integrate::piece::mixed::Mixed;
use crate::integrate::piece::power::Hertz;
use crate::integrate::piece::straight::Straight;
use crate::integrate::rk8::{Constants, Rk8, grown, landed_state, shrunk};
use crate::integrate::{Drag, Integrator as _, Landing, MOST_STEPS, Path, Restoring, State};

/// Lanes whose state is no number, or that go on for ever, are looked for once in so many common steps.
const LOOK: u64 = 1024;

/// The state and the constants of every lane.
#[derive(Debug, Clone, Default)]
struct Rows {
    y: Row,
    u: Row,
    g: Row,
    t: Row,
    h: Row,
    a: Row,
    b: Row,
    c: Row,
    is_straight: Row,
    end: Row,
    target_y: Row,
    target_u: Row,
    target_g: Row,
    direction: Row,
    inverse_y: Row,
    inverse_u: Row,
    left_out_squared: Row,
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
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        let rows = Rows { h: [1.0; LANES], ..Rows::default() };
        Self { rows: Box::new(rows), begun: [None; LANES], rk8: Rk8::new(tolerance), steps: 0, arch: Arch::new() }
    }
}

impl Lanes for Conservative {
    const FEW: usize = 0;

    fn start(&mut self, lane: usize, path: &Path, state: &State) -> Started {
        if path.pull != 0.0 || path.drag != Drag::NONE {
            return Started::Foreign;
        }
        let rows = &mut *self.rows;
        let (leg, node, h) = match path.restoring {
            Restoring::Straight { at_start: a, slope: b } => {
                (rows.a[lane], rows.b[lane], rows.c[lane], rows.is_straight[lane]) = (a, b, 0.0, 1.0);
                self.rk8.begin(Straight::new(a, b, NoPull), path, state)
            }
            Restoring::Power { coefficient, exponent: 1.5 } => {
                let hertz = Hertz::new(coefficient, NoPull);
                (rows.a[lane], rows.b[lane], rows.c[lane], rows.is_straight[lane]) = (0.0, 0.0, hertz.c, 0.0);
                self.rk8.begin(hertz, path, state)
            }
            Restoring::Power { .. } | Restoring::Smooth { .. } => return Started::Foreign,
        };
        (rows.y[lane], rows.u[lane], rows.g[lane], rows.t[lane], rows.h[lane]) = (node.y, node.u, node.g, node.t, h);
        let target = leg.target;
        (rows.end[lane], rows.target_y[lane], rows.target_u[lane]) = (target.end, target.y, target.u);
        (rows.target_g[lane], rows.direction[lane]) = (target.g, target.direction);
        (rows.inverse_y[lane], rows.inverse_u[lane], rows.left_out_squared[lane]) =
            (leg.inverse_y, leg.inverse_u, leg.left_out_squared);
        self.begun[lane] = Some(self.steps);
        Started::UnderWay
    }

    #[inline]
    fn step(&mut self) -> bool {
        self.arch.dispatch(Kernel(&mut self.rows));
        self.steps += 1;
        self.steps.is_multiple_of(LOOK) || self.rows.landed.iter().any(|landed| *landed != 0.0)
    }

    #[inline]
    fn take_landing(&mut self, lane: usize, path: &Path, begun: &State) -> Option<Landed> {
        let rows = &*self.rows;
        if rows.landed[lane] == 0.0 {
            if !self.steps.is_multiple_of(LOOK) {
                return None;
            }
            let is_number =
                [rows.y[lane], rows.u[lane], rows.t[lane], rows.h[lane]].iter().all(|part| part.is_finite());
            self.begun[lane].take_if(|begun| !is_number || self.steps - *begun >= MOST_STEPS)?;
            // by itself it says what is wrong, or does not fail
            let mut state = *begun;
            return Some(self.rk8.traverse(path, &mut state, None).map(|landing| (landing, state)));
        }
        self.begun[lane].take()?;
        let node = Node { y: rows.y[lane], u: rows.u[lane], g: rows.g[lane], t: rows.t[lane] };
        let landing = if rows.landed[lane] == AT_END { Landing::End } else { Landing::Turning };
        let state = match path.restoring {
            Restoring::Straight { at_start, slope } => {
                landed_state(Straight::new(at_start, slope, NoPull), path, landing, &node, 0.0)
            }
            Restoring::Power { coefficient, .. } => {
                landed_state(Hertz::new(coefficient, NoPull), path, landing, &node, 0.0)
            }
            // never started
            Restoring::Smooth { .. } => return None,
        };
        Some(Ok((landing, state)))
    }

    fn finish(&mut self, lane: usize, path: &Path, begun: &State) -> Option<Landed> {
        // with no FEW, every leg is stepped to its end
        self.take_landing(lane, path, begun)
    }
}

/// One step of all lanes.
struct Kernel<'a>(&'a mut Rows);

impl WithSimd for Kernel<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let rows = self.0;
        let mut first = 0;
        while first + REGISTERS <= S::as_simd_f64s(&rows.h).0.len() {
            macro_rules! row {
                ($row:ident) => {
                    load!(rows.$row, simd, first)
                };
            }
            let now = Node { y: row!(y), u: row!(u), g: row!(g), t: row!(t) };
            let field = Mixed { a: row!(a), b: row!(b), c: row!(c), is_straight: row!(is_straight) };
            let target = Target {
                end: row!(end),
                y: row!(target_y),
                u: row!(target_u),
                g: row!(target_g),
                direction: row!(direction),
            };
            let leg = Constants {
                target,
                inverse_y: row!(inverse_y),
                inverse_u: row!(inverse_u),
                left_out_squared: row!(left_out_squared),
            };
            let (node, next_h, kind) = step(field, &leg, &now, row!(h));
            store!(node.y, rows.y, first);
            store!(node.u, rows.u, first);
            store!(node.g, rows.g, first);
            store!(node.t, rows.t, first);
            store!(next_h, rows.h, first);
            store!(kind, rows.landed, first);
            first += REGISTERS;
        }
    }
}

/// One pass of the loop of rk8, with choices instead of branches: the node after it, the next step, the kind of landing.
#[inline(always)]
fn step<T: Lane>(field: Mixed<T>, leg: &Constants<T>, now: &Node<T>, h: T) -> (Node<T>, T, T) {
    let zero = h.all(0.0);
    let one = h.all(1.0);
    let reach = leg.target.reach(now, h);
    let gap = (leg.target.y - now.y).abs();
    let (limited, last) = leg.target.limit(now, h);
    let this = reach.if_less(gap, h, limited);
    let may_land = reach.if_less(gap, zero, h.if_less(last, zero, one));

    let stepped = leg.step(field, now, this);
    let landed = leg.target.land(field, &stepped.node);
    let is_rejected = one.if_less(stepped.error, one, zero);
    let is_mended = landed.left_out_squared.if_less(leg.left_out_squared, may_land, zero);
    let lands = zero.if_less(is_rejected, zero, is_mended);

    macro_rules! pick {
        ($part:ident) => {
            zero.if_less(is_rejected, now.$part, zero.if_less(lands, landed.node.$part, stepped.node.$part))
        };
    }
    let node = Node { y: pick!(y), u: pick!(u), g: pick!(g), t: pick!(t) };
    let next = zero.if_less(is_rejected, shrunk(this, stepped.error), grown(this, stepped.error));
    (node, next, zero.if_less(lands, landed.kind, zero))
}
