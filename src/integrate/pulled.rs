//! rk8 under a pull: y'' = g(y) + what a constant acceleration γ gives in the same variables (see [`super::rk8`]).
//!
//! On a straight piece the pull is a constant, in s = √d it is 2 γ s: both remain Nyström problems. With drag, and on curves
//! that are neither, they do not, and the damped stepper takes over.

use super::damped::Damped;
use super::field::{Field, Variables};
use super::forced::{Drag, ForcedIntegrator, ForcedLanding, ForcedPath, ForcedState};
use super::rk8::Rk8;
use super::{IntegrationError, Landing, Leg, Path, Restoring, Sampler, State, Work};
use crate::functions::pow;
use crate::power::power_turn;

/// rk8 for motions under a pull, with or without drag.
#[derive(Debug, Clone)]
pub struct Pulled {
    rk8: Rk8,
    damped: Damped,
}

impl Pulled {
    /// A stepper with this relative tolerance.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self { rk8: Rk8::new(tolerance), damped: Damped::new(tolerance) }
    }
}

/// Straight: g = −(a + b y), y = d, with the pull in a, which may be negative.
#[derive(Debug, Clone, Copy)]
struct Straight {
    a: f64,
    b: f64,
}

/// Hertz in s = √d: g = −c s⁴ + p s with p = 2 γ.
#[derive(Debug, Clone, Copy)]
struct Hertz {
    c: f64,
    p: f64,
}

/// Any power law in s: g = −c s^m + p s with m = 2 n + 1.
#[derive(Debug, Clone, Copy)]
struct Power {
    c: f64,
    m: f64,
    p: f64,
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
    const IS_PULLED: bool = true;
    const IS_TIME: bool = true;
    const IS_POLYNOMIAL: bool = true;
    fn y_at(self, distance: f64) -> f64 {
        distance
    }
    fn distance_at(self, y: f64) -> f64 {
        y
    }
    fn potential(self, y: f64) -> f64 {
        y * (self.a + 0.5 * self.b * y)
    }
    fn at_potential(self, potential: f64) -> f64 {
        let root = (self.a * self.a + 2.0 * self.b * potential).max(0.0).sqrt();
        if self.a > 0.0 { 2.0 * potential / (self.a + root) } else { (root - self.a) / self.b }
    }
}

impl Field<f64> for Hertz {
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, p: self.p * factor }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        let square = y * y;
        self.p * y - self.c * (square * square)
    }
    #[inline(always)]
    fn derivatives(self, y: f64) -> (f64, f64) {
        let second = self.c * (y * y) * -12.0;
        (second * y * (1.0 / 3.0) + self.p, second)
    }
    #[inline(always)]
    fn duration(self, h: f64, mean: f64) -> f64 {
        2.0 * mean * h
    }
}

impl Field<f64> for Power {
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, p: self.p * factor, ..self }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        self.p * y - self.c * pow(y.abs(), self.m)
    }
    #[inline(always)]
    fn derivatives(self, y: f64) -> (f64, f64) {
        let second = -self.c * self.m * (self.m - 1.0) * pow(y.abs(), self.m - 2.0);
        (second * y / (self.m - 1.0) + self.p, second)
    }
    #[inline(always)]
    fn duration(self, h: f64, mean: f64) -> f64 {
        2.0 * mean * h
    }
}

macro_rules! square_root_variable {
    ($field:ident, $power:expr) => {
        const IS_PULLED: bool = true;
        const IS_TIME: bool = false;
        fn y_at(self, distance: f64) -> f64 {
            distance.sqrt()
        }
        fn distance_at(self, y: f64) -> f64 {
            y * y
        }
        fn at_potential(self, potential: f64) -> f64 {
            // potential = k d^(n+1)/(n+1) − γ d
            let $field = self;
            let (n, k, pull) = (0.5 * ($power - 1.0), 0.5 * self.c, 0.5 * self.p);
            power_turn(k, n, potential.max(0.0), pull).sqrt()
        }
        fn potential(self, y: f64) -> f64 {
            let $field = self;
            let q = $power + 1.0;
            self.c / q * pow(y.abs(), q) - 0.5 * self.p * y * y
        }
        // where the pull is stronger than the force, it sets the pace
        fn stiffness(self, y: f64) -> f64 {
            2.0 * self.p - self.derivatives(y).0
        }
    };
}

impl Variables for Hertz {
    const IS_POLYNOMIAL: bool = true;
    square_root_variable!(_field, 4.0);
}

impl Variables for Power {
    const IS_POLYNOMIAL: bool = false;
    square_root_variable!(field, field.m);
}

/// Whether the balance of energy sees a way back to the zero of the force: rounding may not, where all of it is needed.
fn comes_back<F: Variables>(field: F, path: &Path, state: &State) -> bool {
    /// Of the depth of the potential.
    const LEAST: f64 = 1e-10;
    let y = field.y_at(state.distance);
    let left = 0.5 * state.speed * state.speed + field.potential(y);
    path.leg != Leg::Back || (state.speed == 0.0 && left > LEAST * path.sizes.speed * path.sizes.speed)
}

impl Pulled {
    /// The leg by rk8; `None` if that is not its kind.
    fn conservative(
        &mut self,
        path: &Path,
        pull: f64,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Option<Result<Landing, IntegrationError>> {
        let rk8 = &mut self.rk8;
        macro_rules! traverse {
            ($field:expr) => {{
                let field = $field;
                comes_back(field, path, state).then(|| rk8.traverse_field(field, path, state, samples))
            }};
        }
        let p = 2.0 * pull;
        match path.restoring {
            Restoring::Straight { at_start, slope: b } => traverse!(Straight { a: at_start - pull, b }),
            Restoring::Power { coefficient, exponent: 1.5 } => traverse!(Hertz { c: 2.0 * coefficient, p }),
            Restoring::Power { coefficient, exponent } => {
                traverse!(Power { c: 2.0 * coefficient, m: 2.0 * exponent + 1.0, p })
            }
            Restoring::Smooth { .. } => None,
        }
    }
}

impl ForcedIntegrator for Pulled {
    fn traverse(
        &mut self,
        path: &ForcedPath,
        state: &mut ForcedState,
        mut samples: Option<&mut Sampler>,
    ) -> Result<ForcedLanding, IntegrationError> {
        if path.drag == Drag::None && path.back_to == 0.0 {
            let landed = self.conservative(&path.path, path.pull, &mut state.state, samples.as_deref_mut());
            if let Some(landed) = landed {
                if let Some(samples) = samples {
                    samples.losses.resize(samples.states.len(), state.loss);
                }
                return landed.map(|landing| match landing {
                    Landing::End => ForcedLanding::End,
                    Landing::Turning => ForcedLanding::Turning,
                });
            }
        }
        self.damped.traverse(path, state, samples)
    }

    fn work(&self) -> Work {
        use super::Integrator as _;
        let (a, b) = (self.rk8.work(), self.damped.work());
        Work {
            steps: a.steps + b.steps,
            rejected: a.rejected + b.rejected,
            force_evaluations: a.force_evaluations + b.force_evaluations,
        }
    }
}
