//! rk8 for many motions at once: every lane has its own piece, state and step size, and all of them step together.
//!
//! The formulas are those of [`super::rk8`], evaluated on registers of whatever width the machine has (chosen at run
//! time), so a lane gives the same bits as the stepper by itself.

use pulp::{Arch, Simd, WithSimd};

use super::field::{Hertz, Mixed, Straight};
use super::landing::{AT_END, Node, Target};
use super::lanes::{Lane, Wide};
use super::rk8::{Constants, Rk8, grown, landed_state, shrunk};
use super::{Landing, Path, Restoring, State};

/// Motions that step together.
pub const LANES: usize = 32;

/// Registers in flight at once: the chain of dependent operations of one step is longer than its arithmetic.
const REGISTERS: usize = 2;

type Row = [f64; LANES];

/// The state and the constants of every lane.
#[derive(Debug, Clone)]
struct Rows {
    y: Row,
    u: Row,
    g: Row,
    t: Row,
    h: Row,
    a: Row,
    b: Row,
    c: Row,
    is_time: Row,
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

/// Lanes of rk8.
#[derive(Debug, Clone)]
pub struct Lockstep {
    rows: Box<Rows>,
    paths: [Option<Path>; LANES],
    rk8: Rk8,
    arch: Arch,
}

impl Lockstep {
    /// Lanes of this relative tolerance, all idle.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        let row = [0.0; LANES];
        let rows = Rows {
            y: row,
            u: row,
            g: row,
            t: row,
            h: [1.0; LANES],
            a: row,
            b: row,
            c: row,
            is_time: row,
            end: row,
            target_y: row,
            target_u: row,
            target_g: row,
            direction: row,
            inverse_y: row,
            inverse_u: row,
            left_out_squared: row,
            landed: row,
        };
        Self { rows: Box::new(rows), paths: [None; LANES], rk8: Rk8::new(tolerance), arch: Arch::new() }
    }

    /// Puts a leg into a lane. `false` if it is none that lanes can do: power laws other than Hertz's, and formulas.
    #[must_use]
    pub fn start(&mut self, lane: usize, path: &Path, state: &State) -> bool {
        let rows = &mut *self.rows;
        let (leg, node, h) = match path.restoring {
            Restoring::Straight { at_start: a, slope: b } => {
                (rows.a[lane], rows.b[lane], rows.c[lane], rows.is_time[lane]) = (a, b, 0.0, 1.0);
                self.rk8.begin(Straight { a, b }, path, state)
            }
            Restoring::Power { coefficient, exponent: 1.5 } => {
                let c = 2.0 * coefficient;
                (rows.a[lane], rows.b[lane], rows.c[lane], rows.is_time[lane]) = (0.0, 0.0, c, 0.0);
                self.rk8.begin(Hertz { c }, path, state)
            }
            Restoring::Power { .. } | Restoring::Smooth { .. } => return false,
        };
        (rows.y[lane], rows.u[lane], rows.g[lane], rows.t[lane], rows.h[lane]) = (node.y, node.u, node.g, node.t, h);
        let target = leg.target;
        (rows.end[lane], rows.target_y[lane], rows.target_u[lane]) = (target.end, target.y, target.u);
        (rows.target_g[lane], rows.direction[lane]) = (target.g, target.direction);
        (rows.inverse_y[lane], rows.inverse_u[lane], rows.left_out_squared[lane]) =
            (leg.inverse_y, leg.inverse_u, leg.left_out_squared);
        self.paths[lane] = Some(*path);
        true
    }

    /// One step, accepted or rejected, in every lane; whether it landed any.
    pub fn step(&mut self) -> bool {
        self.arch.dispatch(Kernel(&mut self.rows));
        self.rows.landed.iter().any(|landed| *landed != 0.0)
    }

    /// Whether the state of a lane is a number.
    #[must_use]
    pub fn is_number(&self, lane: usize) -> bool {
        let rows = &*self.rows;
        [rows.y[lane], rows.u[lane], rows.t[lane], rows.h[lane]].iter().all(|part| part.is_finite())
    }

    /// Takes the landing of a lane, if the last step landed it; the lane is then idle.
    pub fn take_landing(&mut self, lane: usize) -> Option<(Landing, State)> {
        if self.rows.landed[lane] == 0.0 {
            return None;
        }
        let path = self.paths[lane].take()?;
        let rows = &*self.rows;
        let node = Node { y: rows.y[lane], u: rows.u[lane], g: rows.g[lane], t: rows.t[lane] };
        let landing = if rows.landed[lane] == AT_END { Landing::End } else { Landing::Turning };
        Some((
            landing,
            match path.restoring {
                Restoring::Straight { at_start: a, slope: b } => {
                    landed_state(Straight { a, b }, path.leg, landing, &node)
                }
                Restoring::Power { coefficient, .. } => {
                    landed_state(Hertz { c: 2.0 * coefficient }, path.leg, landing, &node)
                }
                // never started
                Restoring::Smooth { .. } => return None,
            },
        ))
    }
}

/// One step of all lanes.
struct Kernel<'a>(&'a mut Rows);

impl WithSimd for Kernel<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        macro_rules! registers {
            ($($row:ident),*) => { $(let $row = S::as_mut_simd_f64s(&mut self.0.$row).0;)* };
        }
        registers!(y, u, g, t, h, a, b, c, is_time, end, target_y, target_u, target_g, direction);
        registers!(inverse_y, inverse_u, left_out_squared, landed);
        let mut first = 0;
        while first + REGISTERS <= y.len() {
            macro_rules! load {
                ($row:ident) => {
                    Wide::<S, REGISTERS>::load(simd, &$row[first..])
                };
            }
            let now = Node { y: load!(y), u: load!(u), g: load!(g), t: load!(t) };
            let field = Mixed { a: load!(a), b: load!(b), c: load!(c), is_time: load!(is_time) };
            let target = Target {
                end: load!(end),
                y: load!(target_y),
                u: load!(target_u),
                g: load!(target_g),
                direction: load!(direction),
            };
            let leg = Constants {
                target,
                inverse_y: load!(inverse_y),
                inverse_u: load!(inverse_u),
                left_out_squared: load!(left_out_squared),
            };
            let (node, next_h, kind) = step(field, &leg, &now, load!(h));
            node.y.store(&mut y[first..]);
            node.u.store(&mut u[first..]);
            node.g.store(&mut g[first..]);
            node.t.store(&mut t[first..]);
            next_h.store(&mut h[first..]);
            kind.store(&mut landed[first..]);
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
