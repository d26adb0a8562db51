//! The pieces as rk8 sees them: y'' = g(y) in variables in which g is smooth (see [`super::rk8`]).

use super::lanes::Lane;
use crate::functions::pow;
use crate::smooth::{Jet, Smooth};

/// g(y) of one smooth piece in its own variables, with what stepping, landing and dense output need.
pub(super) trait Field<T: Lane>: Copy {
    /// The field of factor × g.
    fn scaled(self, factor: T) -> Self;
    /// g(y).
    fn g(self, y: T) -> T;
    /// (g', g'') at y; g' ≤ 0.
    fn derivatives(self, y: T) -> (T, T);
    /// The time that a stretch h of σ with this mean of y takes.
    fn duration(self, h: T, mean: T) -> T;
}

/// The variables of a piece, needed where a leg begins and ends.
pub(super) trait Variables: Field<f64> {
    /// Whether σ is the time.
    const IS_TIME: bool;
    /// Whether g is a polynomial, or as smooth as one, also at y = 0.
    const IS_POLYNOMIAL: bool;
    /// Whether a pull may be stronger than the force.
    const IS_PULLED: bool = false;
    /// y for a distance d.
    fn y_at(self, distance: f64) -> f64;
    /// d for y.
    fn distance_at(self, y: f64) -> f64;
    /// Potential −∫ g.
    fn potential(self, y: f64) -> f64;
    /// The y > 0 of a given potential.
    fn at_potential(self, potential: f64) -> f64;
    /// −g' at y, for the first step.
    #[inline(always)]
    fn stiffness(self, y: f64) -> f64 {
        -self.derivatives(y).0
    }
}

/// Straight: g = −(a + b y), y = d.
#[derive(Debug, Clone, Copy)]
pub(super) struct Straight {
    pub(super) a: f64,
    pub(super) b: f64,
}

impl Field<f64> for Straight {
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { a: self.a * factor, b: self.b * factor }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        -(self.a + self.b * y)
    }
    #[inline(always)]
    fn derivatives(self, _: f64) -> (f64, f64) {
        (-self.b, 0.0)
    }
    #[inline(always)]
    fn duration(self, h: f64, _: f64) -> f64 {
        h
    }
}

impl Variables for Straight {
    const IS_TIME: bool = true;
    const IS_POLYNOMIAL: bool = true;
    #[inline(always)]
    fn y_at(self, distance: f64) -> f64 {
        distance
    }
    #[inline(always)]
    fn distance_at(self, y: f64) -> f64 {
        y
    }
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        y * (self.a + 0.5 * self.b * y)
    }
    #[inline(always)]
    fn at_potential(self, potential: f64) -> f64 {
        2.0 * potential / (self.a + (self.a * self.a + 2.0 * self.b * potential).sqrt())
    }
}

/// Power law in s = √d: g = −c s^p with c = 2 k, p = 2 n + 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Power {
    pub(super) c: f64,
    pub(super) p: f64,
}

/// The same for n = 3/2: g = −c s⁴.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hertz {
    pub(super) c: f64,
}

macro_rules! square_root_variable {
    () => {
        const IS_TIME: bool = false;
        #[inline(always)]
        fn y_at(self, distance: f64) -> f64 {
            distance.sqrt()
        }
        #[inline(always)]
        fn distance_at(self, y: f64) -> f64 {
            y * y
        }
    };
}

impl Field<f64> for Hertz {
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        let square = y * y;
        -(self.c * (square * square))
    }
    #[inline(always)]
    fn derivatives(self, y: f64) -> (f64, f64) {
        let second = self.c * (y * y) * -12.0;
        (second * y * (1.0 / 3.0), second)
    }
    #[inline(always)]
    fn duration(self, h: f64, mean: f64) -> f64 {
        2.0 * mean * h
    }
}

impl Variables for Hertz {
    const IS_POLYNOMIAL: bool = true;
    square_root_variable!();
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        let square = y * y;
        0.2 * self.c * square * square * y
    }
    #[inline(always)]
    fn at_potential(self, potential: f64) -> f64 {
        pow(5.0 * potential / self.c, 0.2)
    }
}

impl Field<f64> for Power {
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        -self.c * pow(y.abs(), self.p)
    }
    #[inline(always)]
    fn derivatives(self, y: f64) -> (f64, f64) {
        let second = -self.c * self.p * (self.p - 1.0) * pow(y.abs(), self.p - 2.0);
        (second * y / (self.p - 1.0), second)
    }
    #[inline(always)]
    fn duration(self, h: f64, mean: f64) -> f64 {
        2.0 * mean * h
    }
}

impl Variables for Power {
    const IS_POLYNOMIAL: bool = false;
    square_root_variable!();
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        self.c / (self.p + 1.0) * pow(y.abs(), self.p + 1.0)
    }
    #[inline(always)]
    fn at_potential(self, potential: f64) -> f64 {
        pow((self.p + 1.0) * potential / self.c, 1.0 / (self.p + 1.0))
    }
}

/// Any smooth force, y = d: g = −c f(start + y).
#[derive(Debug, Clone, Copy)]
pub(super) struct Plain {
    pub(super) force: Smooth,
    pub(super) start: f64,
    pub(super) c: f64,
}

impl Field<f64> for Plain {
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    fn g(self, y: f64) -> f64 {
        -self.c * self.force.at_variable(self.start + y)
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let Jet { slope, curvature, .. } = self.force.jet(self.start + y);
        (-self.c * slope, -self.c * curvature)
    }
    fn duration(self, h: f64, _: f64) -> f64 {
        h
    }
}

impl Variables for Plain {
    const IS_TIME: bool = true;
    const IS_POLYNOMIAL: bool = false;
    fn y_at(self, distance: f64) -> f64 {
        distance
    }
    fn distance_at(self, y: f64) -> f64 {
        y
    }
    fn potential(self, y: f64) -> f64 {
        self.c * self.force.work(self.start, 0.0, y)
    }
    fn at_potential(self, potential: f64) -> f64 {
        // the force so far is about that of a straight line from x = 0
        let before = 0.5 * self.start * self.force.at_variable(self.start);
        self.force.distance_at_work(self.start, before, potential / self.c)
    }
}

/// A force that is smooth in y = √d and odd: g = −c y f(y) with c = 2 k.
#[derive(Debug, Clone, Copy)]
pub(super) struct OfRoot {
    pub(super) force: Smooth,
    pub(super) c: f64,
}

impl Field<f64> for OfRoot {
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    fn g(self, y: f64) -> f64 {
        -self.c * y * self.force.at_variable(y)
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let Jet { value, slope, curvature } = self.force.jet(y);
        (-self.c * (value + y * slope), -self.c * (2.0 * slope + y * curvature))
    }
    fn duration(self, h: f64, mean: f64) -> f64 {
        2.0 * mean * h
    }
}

impl Variables for OfRoot {
    const IS_POLYNOMIAL: bool = true;
    square_root_variable!();
    fn potential(self, y: f64) -> f64 {
        0.5 * self.c * self.force.work(0.0, 0.0, y * y)
    }
    fn at_potential(self, potential: f64) -> f64 {
        self.force.distance_at_work(0.0, 0.0, 2.0 * potential / self.c).sqrt()
    }
}

/// Straight and Hertz pieces side by side in lock step: g = −(a + b y + c y⁴); where a piece has no
/// such term its coefficient is zero, which leaves every bit of the others as [`Straight`] and [`Hertz`] have it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mixed<T> {
    pub(super) a: T,
    pub(super) b: T,
    pub(super) c: T,
    /// 1 on a straight piece, 0 on a Hertz piece.
    pub(super) is_time: T,
}

impl<T: Lane> Field<T> for Mixed<T> {
    #[inline(always)]
    fn scaled(self, factor: T) -> Self {
        Self { a: self.a * factor, b: self.b * factor, c: self.c * factor, is_time: self.is_time }
    }
    #[inline(always)]
    fn g(self, y: T) -> T {
        let square = y * y;
        -((self.a + self.b * y) + self.c * (square * square))
    }
    #[inline(always)]
    fn derivatives(self, y: T) -> (T, T) {
        let second = self.c * (y * y) * -12.0;
        (second * y * (1.0 / 3.0) - self.b, second)
    }
    #[inline(always)]
    fn duration(self, h: T, mean: T) -> T {
        let zero = h.all(0.0);
        zero.if_less(self.is_time, h, mean * 2.0 * h)
    }
}
