//! The velocity of an arriving sphere: its speed, and for an oblique impact the angle, the spin and the friction.

use crate::numerics::functions::{atan2, hypot, sin_cos};

/// The direction, the spin and the friction of an arriving sphere.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Incidence {
    /// θ \[rad\] from the normal, −π/2 < θ < π/2.
    pub angle: f64,
    /// ω \[rad/s\] before the impact; positive for rolling forward.
    pub spin: f64,
    /// Coefficient of friction μ \[1\].
    pub friction: f64,
}

/// The speed of a sphere, and its incidence if the impact is not normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// The magnitude of the velocity \[m/s\].
    pub speed: f64,
    /// `None` without angle and spin: friction is then not computed.
    pub incidence: Option<Incidence>,
}

impl From<f64> for Approach {
    /// A normal impact.
    fn from(speed: f64) -> Self {
        Self { speed, incidence: None }
    }
}

impl Approach {
    /// From the velocities normal to the half-space and along it; a negative tangential velocity points backwards.
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
