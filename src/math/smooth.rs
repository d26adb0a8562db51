//! Increasing smooth forces that are neither a power from zero nor a straight line: value, derivatives, work, inverse of the
//! work, and the time that a motion against them takes.
//!
//! The formula of a force is written once, in the file of its law, for any [`Number`]. With plain `f64` it gives the force,
//! with a [`Jet`] the force and its first two derivatives.

use crate::math::quadrature;
use crate::math::root::{bracketed, fallen_from};

mod number;

pub use number::{Jet, Number};

/// Numbers a formula may depend on.
pub type Parameters = [f64; 3];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variable {
    /// x itself. The formula is smooth in x from the start of its piece on.
    Indentation,
    /// y = √d with d from the start of the piece, where the force vanishes as d^(3/2).
    RootOfDistance,
}

/// A force law as code. It serves all contacts; each contact has its own [`Parameters`].
#[derive(Debug)]
pub struct Formula {
    variable: Variable,
    value: fn(&Parameters, f64) -> f64,
    jet: fn(&Parameters, Jet) -> Jet,
    /// Of a function of √d: ∫ f dd, where there is one in closed form.
    integral: Option<fn(&Parameters, f64) -> f64>,
}

impl Formula {
    /// A function of x.
    pub const fn new(value: fn(&Parameters, f64) -> f64, jet: fn(&Parameters, Jet) -> Jet) -> Self {
        Self { variable: Variable::Indentation, value, jet, integral: None }
    }

    /// A function of √d.
    pub(crate) const fn of_root(
        value: fn(&Parameters, f64) -> f64,
        jet: fn(&Parameters, Jet) -> Jet,
        integral: Option<fn(&Parameters, f64) -> f64>,
    ) -> Self {
        Self { variable: Variable::RootOfDistance, value, jet, integral }
    }
}

/// A formula with its parameters. Distances d are from the `start` of the piece it stands on.
#[derive(Debug, Clone, Copy)]
pub struct Smooth {
    formula: &'static Formula,
    parameters: Parameters,
}

impl PartialEq for Smooth {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.formula, other.formula) && self.parameters == other.parameters
    }
}

impl Smooth {
    pub const fn new(formula: &'static Formula, parameters: Parameters) -> Self {
        Self { formula, parameters }
    }

    pub(crate) fn is(&self, formula: &'static Formula) -> bool {
        std::ptr::eq(self.formula, formula)
    }

    pub(crate) fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    pub fn variable(&self) -> Variable {
        self.formula.variable
    }

    #[cold]
    pub fn value(&self, start: f64, distance: f64) -> f64 {
        match self.formula.variable {
            Variable::Indentation => (self.formula.value)(&self.parameters, start + distance),
            // continued as an odd function, as a power from zero is
            Variable::RootOfDistance => {
                distance.signum() * (self.formula.value)(&self.parameters, distance.abs().sqrt())
            }
        }
    }

    /// df/dd at a distance.
    pub fn slope(&self, start: f64, distance: f64) -> f64 {
        match self.formula.variable {
            Variable::Indentation => self.jet(start + distance).slope,
            Variable::RootOfDistance if distance <= 0.0 => 0.5 * self.jet(0.0).curvature,
            Variable::RootOfDistance => {
                let y = distance.sqrt();
                self.jet(y).slope / (2.0 * y)
            }
        }
    }

    /// f and its derivatives as a function of its own variable.
    #[inline]
    pub(crate) fn jet(&self, argument: f64) -> Jet {
        (self.formula.jet)(&self.parameters, Jet::variable(argument))
    }

    #[inline]
    pub(crate) fn at_variable(&self, argument: f64) -> f64 {
        (self.formula.value)(&self.parameters, argument)
    }

    /// ∫ f dd between two distances.
    #[cold] // so that these calls do not slow the pieces in closed form
    pub fn work(&self, start: f64, from: f64, to: f64) -> f64 {
        match (self.formula.variable, self.formula.integral) {
            (Variable::Indentation, _) => {
                quadrature::over_decades(start + from, start + to, |x| (self.formula.value)(&self.parameters, x))
            }
            (Variable::RootOfDistance, Some(integral)) => {
                let up_to = |distance: f64| integral(&self.parameters, distance.max(0.0).sqrt());
                up_to(to) - up_to(from)
            }
            (Variable::RootOfDistance, None) => {
                let force = |y: f64| 2.0 * y * (self.formula.value)(&self.parameters, y);
                let (from, to) = (from.max(0.0).sqrt(), to.max(0.0).sqrt());
                let middle = 0.5 * (from + to);
                quadrature::panel(from, middle, force) + quadrature::panel(middle, to, force)
            }
        }
    }

    /// The distance at which the work from the start, less that of a constant `pull`, is `work` ≥ 0, beyond where the pull and
    /// the force balance.
    #[cold]
    pub(crate) fn distance_at_work(&self, start: f64, work: f64, pull: f64) -> f64 {
        if !(work > 0.0 || pull > 0.0) || !work.is_finite() {
            return work.max(0.0);
        }
        // convex, and falling beyond the balance
        let missing = |distance: f64| work + pull * distance - self.work(start, 0.0, distance);
        let (mut low, mut high) = (0.0, if start > 0.0 { start } else { 1.0 });
        for _ in 0..200 {
            match missing(high) {
                left if left > 0.0 => (low, high) = (high, 2.0 * high),
                // beyond its range a formula may give no number
                left if left.is_nan() => high = 0.5 * (low + high),
                _ => break,
            }
        }
        fallen_from(high, |distance| missing(distance) / (pull - self.value(start, distance)))
    }

    /// The distance at which f = `force` > f(0), by Newton's method on a function that rises, kept between bounds.
    pub(crate) fn distance_at_force(&self, start: f64, force: f64) -> f64 {
        let (mut low, mut high) = (0.0, if start > 0.0 { start } else { 1.0 });
        while self.value(start, high) < force && high.is_finite() {
            (low, high) = (high, 4.0 * high);
        }
        let is_near = |distance: f64, next: f64| (next - distance).abs() <= f64::EPSILON * distance;
        // what is missing falls; it is no number beyond the range of the formula
        let at = |distance: f64| (force - self.value(start, distance), -self.slope(start, distance));
        bracketed((low, high), 0.5 * (low + high), is_near, at)
    }

    /// The work over the last stretch `by` before a distance, with all digits of a short stretch.
    fn work_before(&self, start: f64, to: f64, by: f64) -> f64 {
        // how far the formula is from its zero: at d = 0 or, for a function of x, at x = 0
        let place = match self.formula.variable {
            Variable::Indentation => start + to,
            Variable::RootOfDistance => to,
        };
        if by < 0.5 * place {
            by * quadrature::panel(0.0, 1.0, |share| self.value(start, to - by * share))
        } else {
            self.work(start, to - by, to)
        }
    }

    /// The time of a motion d'' = −c f between two distances, from the lower to the upper, where the speed is `exit` (0 for a
    /// turning point). The same as that of the way back.
    #[cold]
    pub fn time(&self, start: f64, from: f64, to: f64, exit: f64, c: f64) -> f64 {
        let square = |before: f64| exit * exit + 2.0 * c * self.work_before(start, to, before);
        quadrature::integrate(to - from, |_, before| 1.0 / square(before).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::functions::pow;
    use crate::math::power::{power_time, quarter_period};

    /// x^1.5 as a formula.
    static HERTZ: Formula = Formula::new(raised::<f64>, raised::<Jet>);
    /// The same as a function of the root: y³.
    static CUBE: Formula = Formula::of_root(cube::<f64>, cube::<Jet>, None);

    fn raised<N: Number>(_: &Parameters, x: N) -> N {
        x.powf(1.5)
    }

    fn cube<N: Number>(_: &Parameters, y: N) -> N {
        y * y * y
    }

    const P: Parameters = [1.0, 1.5, 0.0];

    #[test]
    fn times_are_those_of_the_power_law() {
        // d'' = −d^1.5 from x_1 on, turning at x_m: the time from 0 less that from 0 to x_1
        let smooth = Smooth::new(&HERTZ, P);
        for (from, to) in [(1.0, 1.001), (1.0, 2.0), (1.9, 50.0), (1.9, 1e4)] {
            let speed = |x: f64| (0.8 * (pow(to, 2.5) - pow(x, 2.5))).sqrt();
            let entry = speed(0.0);
            let want = to / entry * quarter_period(1.5) - power_time(1.5, from, entry, speed(from));
            let scale = (to / entry) / want;
            approx::assert_relative_eq!(
                smooth.time(from, 0.0, to - from, 0.0, 1.0),
                want,
                max_relative = 1e-14 * scale
            );
            let half = 0.5 * (from + to);
            let want = power_time(1.5, half, entry, speed(half)) - power_time(1.5, from, entry, speed(from));
            let got = smooth.time(from, 0.0, half - from, speed(half), 1.0);
            approx::assert_relative_eq!(got, want, max_relative = 1e-14 * (half / entry) / want);
        }
        let root = Smooth::new(&CUBE, P);
        let to: f64 = 3.0;
        let entry = (0.8 * pow(to, 2.5)).sqrt();
        approx::assert_relative_eq!(root.work(7.0, 0.0, to), 0.4 * pow(to, 2.5), max_relative = 1e-15);
        let time = root.time(7.0, 0.0, to, 0.0, 1.0);
        approx::assert_relative_eq!(time, to / entry * quarter_period(1.5), max_relative = 1e-13);
        approx::assert_relative_eq!(root.distance_at_work(7.0, 0.4 * pow(to, 2.5), 0.0), to, max_relative = 1e-14);
        approx::assert_relative_eq!(root.slope(7.0, 4.0), 3.0, max_relative = 1e-15);
    }
}
