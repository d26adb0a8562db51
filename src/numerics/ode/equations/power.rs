//! A power law from its zero: g = k d^n. Hertz, n = 3/2, is a polynomial in its variables and needs no `powf`; with drag it
//! alone has its own rates.

use super::{DampedEquation, DampedState, NystromEquation};
use crate::numerics::functions::pow;
use crate::numerics::ode::LegProblem;
use crate::numerics::power::power_turning_distance;

/// Without drag, y = √d: g = 2 γ y − c y^m with c = 2 k, m = 2 n + 1; m = 4 for Hertz.
#[derive(Debug, Clone, Copy)]
pub struct PowerEquation<const HERTZ: bool, const PULLED: bool> {
    pub c: f64,
    m: f64,
    /// γ; not used without gravity.
    pull: f64,
}

impl<const HERTZ: bool, const PULLED: bool> PowerEquation<HERTZ, PULLED> {
    #[inline(always)]
    pub fn new(k: f64, n: f64, pull: f64) -> Self {
        Self { c: 2.0 * k, m: 2.0 * n + 1.0, pull }
    }

    /// m, which the compiler knows for Hertz.
    #[inline(always)]
    fn m(self) -> f64 {
        if HERTZ { 4.0 } else { self.m }
    }
}

impl<const HERTZ: bool, const PULLED: bool> NystromEquation for PowerEquation<HERTZ, PULLED> {
    const USES_PLAIN_VARIABLES: bool = false;
    const IS_SMOOTH_AT_ZERO: bool = HERTZ;
    #[inline(always)]
    fn scale_by(self, factor: f64) -> Self {
        Self { c: self.c * factor, pull: self.pull * factor, ..self }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        let square = y * y;
        let power = if HERTZ { square * square } else { pow(y.abs(), self.m) };
        let force = self.c * power;
        if PULLED { 2.0 * self.pull * y - force } else { -force }
    }
    #[inline(always)]
    fn derivatives(self, y: f64) -> (f64, f64) {
        let (slope, second) = if HERTZ {
            let second = self.c * (y * y) * -12.0;
            (second * y * (1.0 / 3.0), second)
        } else {
            let second = -self.c * self.m * (self.m - 1.0) * pow(y.abs(), self.m - 2.0);
            (second * y / (self.m - 1.0), second)
        };
        (if PULLED { slope + 2.0 * self.pull } else { slope }, second)
    }
    /// c y^(m+1)/(m+1) − γ y².
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        if HERTZ && !PULLED {
            let square = y * y;
            return 0.2 * self.c * square * square * y;
        }
        let q = self.m() + 1.0;
        let of_force = self.c / q * pow(y.abs(), q);
        if PULLED { of_force - self.pull * y * y } else { of_force }
    }
    #[inline(always)]
    fn y_at_potential(self, potential: f64) -> f64 {
        if PULLED {
            // potential = k d^(n+1)/(n+1) − γ d
            let (n, k) = (0.5 * (self.m() - 1.0), 0.5 * self.c);
            power_turning_distance(k, n, potential.max(0.0), self.pull).sqrt()
        } else {
            let q = self.m() + 1.0;
            pow(q * potential / self.c, 1.0 / q)
        }
    }
    /// Where the pull is stronger than the force, the first step follows from the pull.
    #[inline(always)]
    fn stiffness(self, y: f64) -> f64 {
        let slope = self.derivatives(y).0;
        if PULLED { 4.0 * self.pull - slope } else { -slope }
    }
}

/// Hertz's law with drag, r = d^(1/m).
#[derive(Debug, Clone, Copy)]
pub struct DampedHertzEquation<const M: u8> {
    k: f64,
    chi: f64,
    /// η √(k n).
    of_root: f64,
    /// (κ + θ) k n.
    of_slope: f64,
    pull: f64,
}

impl<const M: u8> DampedHertzEquation<M> {
    /// The piece k d^1.5 with the pull and the drag of a path.
    pub fn from_leg(k: f64, path: &LegProblem) -> Self {
        let (drag, slope) = (path.drag, 1.5 * k);
        let (chi, of_root, of_slope) = (drag.hunt_crossley, drag.viscous * slope.sqrt(), drag.per_slope() * slope);
        Self { k, chi, of_root, of_slope, pull: path.constant_acceleration }
    }
}

impl<const M: u8> DampedEquation for DampedHertzEquation<M> {
    const VARIABLE_ROOT: i32 = M as i32;
    #[inline(always)]
    fn rates(&self, y: f64, u: f64) -> DampedState {
        let square = y * y;
        if M == 2 {
            // per 2 s: k s³, and (κ + θ) k n s; η would need the root of s
            let (clock, force) = (y * 2.0, self.k * 2.0 * square * square);
            let mut drag = force * self.chi * u;
            if self.of_slope != 0.0 {
                drag += 2.0 * self.of_slope * square * u;
            }
            [u, clock * self.pull - force - drag, clock, drag * u]
        } else {
            let clock = square * 4.0 * y;
            let force = clock * self.k * square * square * square;
            let mut drag = (force * self.chi + clock * self.of_root * y) * u;
            if self.of_slope != 0.0 {
                drag += clock * self.of_slope * square * u;
            }
            [u, clock * self.pull - force - drag, clock, drag * u]
        }
    }
}
