//! The motion of an arriving sphere.

use crate::numerics::functions::{atan2, hypot, sin_cos};

/// The velocity and the spin of a sphere at first contact, and its friction on the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// v_n \[m/s\], towards the half-space.
    pub normal: f64,
    /// v_t \[m/s\] along the surface; negative backwards.
    pub along: f64,
    /// ω \[rad/s\]; positive for rolling forward.
    pub spin: f64,
    /// Coefficient of friction μ \[1\]. `None` for a normal impact, whose friction is not computed.
    pub friction: Option<f64>,
}

impl From<f64> for Approach {
    /// A normal impact.
    fn from(speed: f64) -> Self {
        Self { normal: speed, along: 0.0, spin: 0.0, friction: None }
    }
}

impl Approach {
    /// From the magnitude of the velocity and its angle \[rad\] from the normal.
    #[inline]
    pub fn at_angle(speed: f64, angle: f64, spin: f64, friction: f64) -> Self {
        let (sin, cos) = sin_cos(angle);
        Self { normal: speed * cos, along: speed * sin, spin, friction: Some(friction) }
    }

    /// The magnitude of the velocity \[m/s\].
    pub fn speed(&self) -> f64 {
        if self.along == 0.0 { self.normal } else { hypot(self.normal, self.along) }
    }

    /// The angle of the velocity from the normal \[rad\].
    pub fn angle(&self) -> f64 {
        atan2(self.along, self.normal)
    }
}
