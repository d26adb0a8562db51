//! How a sphere comes in: its speed, and the angle, the spin and the friction where it does not come straight.

use crate::numerics::functions::{atan2, hypot, sin_cos};

/// The direction of a sphere that comes in, its spin and its friction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Incidence {
    /// θ \[rad\] from the normal, −π/2 < θ < π/2.
    pub angle: f64,
    /// ω \[rad/s\] before the impact; positive for rolling forward.
    pub spin: f64,
    /// Coefficient of friction μ \[1\].
    pub friction: f64,
}

/// The speed of a sphere, and how it comes in if it does not come straight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// The whole speed \[m/s\].
    pub speed: f64,
    /// `None` without angle and spin: friction is then not computed.
    pub incidence: Option<Incidence>,
}

impl From<f64> for Approach {
    /// Straight towards the half-space.
    fn from(speed: f64) -> Self {
        Self { speed, incidence: None }
    }
}

impl Approach {
    /// From the speeds normal to the half-space and along it, the latter backwards where it is negative.
    pub fn from_components([normal, tangential]: [f64; 2], spin: f64, friction: f64) -> Self {
        let angle = atan2(tangential, normal);
        Self { speed: hypot(normal, tangential), incidence: Some(Incidence { angle, spin, friction }) }
    }

    /// v_n and v_t.
    #[inline]
    pub fn components(self) -> [f64; 2] {
        let Some(Incidence { angle, .. }) = self.incidence else { return [self.speed, 0.0] };
        let (sin, cos) = sin_cos(angle);
        [self.speed * cos, self.speed * sin]
    }
}
