//! The pieces as the damped stepper sees them: rates in variables in which they are smooth (see [`super::damped`]).

use super::dop853::{Motion, Quad};
use super::forced::ForcedPath;
use super::lanes::Lane;
use crate::root::next_guess;

use crate::functions::{pow, powi};

/// A straight piece: d'' = γ − (a + b d)(1 + χ u) − c u.
#[derive(Debug, Clone, Copy)]
pub(super) struct Straight<T = f64> {
    pub(super) a: T,
    pub(super) b: T,
    pub(super) chi: T,
    pub(super) c: T,
    pub(super) pull: T,
}

/// A power law in r = d^(1/m) for n = 3/2; `c` is √(k n) times the drag of stiffness.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hertz<const M: u8, T = f64> {
    pub(super) k: T,
    pub(super) chi: T,
    pub(super) c: T,
    pub(super) pull: T,
}

/// The two side by side in lock step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mixed<const M: u8, T> {
    pub(super) straight: Straight<T>,
    pub(super) hertz: Hertz<M, T>,
    /// 1 in a lane that is straight, else 0.
    pub(super) is_straight: T,
}

/// The same for any exponent.
#[derive(Debug, Clone, Copy)]
pub(super) struct Power<const M: u8> {
    pub(super) k: f64,
    pub(super) n: f64,
    pub(super) chi: f64,
    pub(super) c: f64,
    pub(super) pull: f64,
}

/// What stepping, landing and sampling need of a motion.
pub(super) trait Piece: Motion<f64> {
    /// m.
    const ROOT: i32;
    /// A function that is zero where the contact force is, and its derivative.
    fn contact(&self, node: &Quad, rates: &Quad) -> (f64, f64);
    /// About √g' at y, for the first step.
    fn frequency(&self, y: f64) -> f64;

    fn y_at(distance: f64) -> f64 {
        match Self::ROOT {
            1 => distance,
            2 => distance.sqrt(),
            _ => distance.sqrt().sqrt(),
        }
    }
    fn distance_at(y: f64) -> f64 {
        powi(y, Self::ROOT)
    }
}

impl Straight {
    /// The piece a + b d with the pull and the drag of a path.
    pub(super) fn along(a: f64, b: f64, path: &ForcedPath) -> Self {
        let (chi, eta) = path.drag.coefficients();
        Self { a, b, chi, c: eta * b.sqrt(), pull: path.pull }
    }
}

impl<T: Lane> Straight<T> {
    #[inline(always)]
    fn contact_force(&self, node: &Quad<T>, rates: &Quad<T>) -> (T, T) {
        (self.a + self.b * node[0] + self.c * node[1], self.b * rates[0] + self.c * rates[1])
    }
}

impl<T: Lane> Motion<T> for Straight<T> {
    #[inline(always)]
    fn rates(&self, y: T, u: T) -> Quad<T> {
        let force = self.a + self.b * y;
        let drag = (force * self.chi + self.c) * u;
        [u, self.pull - force - drag, y.all(1.0), drag * u]
    }
}

impl Piece for Straight {
    const ROOT: i32 = 1;
    fn contact(&self, node: &Quad, rates: &Quad) -> (f64, f64) {
        self.contact_force(node, rates)
    }
    fn frequency(&self, _: f64) -> f64 {
        self.b.sqrt()
    }
}

impl<const M: u8> Hertz<M> {
    /// The piece k d^1.5 with the pull and the drag of a path.
    pub(super) fn along(k: f64, path: &ForcedPath) -> Self {
        let (chi, eta) = path.drag.coefficients();
        Self { k, chi, c: eta * (k * 1.5).sqrt(), pull: path.pull }
    }
}

impl<const M: u8, T: Lane> Hertz<M, T> {
    /// Contact force over d^¼, m = 4: k r⁵ + c u; and its derivative.
    #[inline(always)]
    fn contact_force(&self, node: &Quad<T>, rates: &Quad<T>) -> (T, T) {
        let square = node[0] * node[0];
        let fourth = square * square;
        (self.k * fourth * node[0] + self.c * node[1], self.k * 5.0 * fourth * rates[0] + self.c * rates[1])
    }
}

impl<const M: u8, T: Lane> Motion<T> for Hertz<M, T> {
    #[inline(always)]
    fn rates(&self, y: T, u: T) -> Quad<T> {
        let square = y * y;
        if M == 2 {
            // per 2 s: k s³, and no drag of stiffness
            let (clock, force) = (y * 2.0, self.k * 2.0 * square * square);
            let drag = force * self.chi * u;
            [u, clock * self.pull - force - drag, clock, drag * u]
        } else {
            let clock = square * 4.0 * y;
            let force = clock * self.k * square * square * square;
            let drag = (force * self.chi + clock * self.c * y) * u;
            [u, clock * self.pull - force - drag, clock, drag * u]
        }
    }
}

impl<const M: u8, T: Lane> Mixed<M, T> {
    /// As [`Piece::contact`], of whichever piece a lane is on.
    #[inline(always)]
    pub(super) fn contact(&self, node: &Quad<T>, rates: &Quad<T>) -> (T, T) {
        let (straight, hertz) = (self.straight.contact_force(node, rates), self.hertz.contact_force(node, rates));
        let zero = node[0].all(0.0);
        (zero.if_less(self.is_straight, straight.0, hertz.0), zero.if_less(self.is_straight, straight.1, hertz.1))
    }
}

impl<const M: u8, T: Lane> Motion<T> for Mixed<M, T> {
    #[inline(always)]
    fn rates(&self, y: T, u: T) -> Quad<T> {
        let (straight, mut rates) = (self.straight.rates(y, u), self.hertz.rates(y, u));
        let zero = y.all(0.0);
        for part in 1..4 {
            rates[part] = zero.if_less(self.is_straight, straight[part], rates[part]);
        }
        rates
    }
}

impl<const M: u8> Piece for Hertz<M> {
    const ROOT: i32 = M as i32;
    fn contact(&self, node: &Quad, rates: &Quad) -> (f64, f64) {
        self.contact_force(node, rates)
    }
    fn frequency(&self, y: f64) -> f64 {
        frequency(self.k, 1.5, y, Self::ROOT)
    }
}

impl<const M: u8> Motion<f64> for Power<M> {
    #[inline(always)]
    fn rates(&self, y: f64, u: f64) -> Quad {
        let m = f64::from(M);
        let clock = m * powi(y, i32::from(M) - 1);
        let size = y.abs();
        let force = clock * self.k * pow(size, m * self.n);
        let of_stiffness = if self.c == 0.0 { 0.0 } else { clock * self.c * pow(size, 0.5 * m * (self.n - 1.0)) };
        let drag = (force * self.chi + of_stiffness) * u;
        [u, clock * self.pull - force - drag, clock, drag * u]
    }
}

impl<const M: u8> Piece for Power<M> {
    const ROOT: i32 = M as i32;
    fn contact(&self, node: &Quad, rates: &Quad) -> (f64, f64) {
        // contact force over d^((n−1)/2): k r^(m(n+1)/2) + c u
        let p = 0.5 * f64::from(M) * (self.n + 1.0);
        let slope = self.k * p * pow(node[0].abs(), p - 1.0);
        (slope * node[0] / p + self.c * node[1], slope * rates[0] + self.c * rates[1])
    }
    fn frequency(&self, y: f64) -> f64 {
        frequency(self.k, self.n, y, Self::ROOT)
    }
}

/// Where in (0, 1) the cubic with these values and slopes at both ends is least, if it falls at first and rises at last.
pub(super) fn cubic_minimum(before: f64, slope_before: f64, after: f64, slope_after: f64) -> Option<f64> {
    if slope_before >= 0.0 || slope_after <= 0.0 {
        return None;
    }
    // slope s_0 + 2 b x + 3 a x², which has one rising zero between
    let rise = after - before;
    let b = 3.0 * rise - 2.0 * slope_before - slope_after;
    let a = slope_before + slope_after - 2.0 * rise;
    let root = (b * b - 3.0 * a * slope_before).max(0.0).sqrt();
    let x = if b > 0.0 { -slope_before / (b + root) } else { (root - b) / (3.0 * a) };
    (x > 0.0 && x < 1.0).then_some(x)
}

/// Where in (0, 1) the cubic with these values and slopes at both ends is zero; `before` > 0 ≥ `after`.
pub(super) fn cubic_root(before: f64, slope_before: f64, after: f64, slope_after: f64) -> f64 {
    let at = |x: f64| {
        let y = 1.0 - x;
        let value =
            y * y * ((1.0 + 2.0 * x) * before + x * slope_before) + x * x * ((3.0 - 2.0 * x) * after - y * slope_after);
        let slope =
            6.0 * x * y * (after - before) + y * (1.0 - 3.0 * x) * slope_before + x * (3.0 * x - 2.0) * slope_after;
        (value, slope)
    };
    let (mut low, mut high) = (0.0, 1.0);
    let mut x = if before > after { before / (before - after) } else { 1.0 };
    for _ in 0..60 {
        let (value, slope) = at(x);
        if value > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        let next = next_guess(newton, low, high);
        if (next - x).abs() <= 1e-12 {
            return next;
        }
        x = next;
    }
    x
}

/// √ of −du'/dr of a power law.
fn frequency(k: f64, n: f64, y: f64, m: i32) -> f64 {
    let m = f64::from(m);
    let p = m - 1.0 + m * n;
    (m * k * p * pow(y, p - 1.0)).sqrt()
}
