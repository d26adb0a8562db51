//! The motion of an arriving sphere.

use super::tangential_motion::TangentialMotion;
use crate::numerics::functions::{atan2, hypot, sin_cos};

/// The velocity and the spin of a sphere at first contact, and its friction on the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// v_n \[m/s\], towards the half-space.
    pub normal: f64,
    /// Tangential velocity and spin.
    pub tangential: TangentialMotion,
    /// Coefficient of friction μ \[1\]. `None` for a normal impact, whose friction is not computed.
    pub friction: Option<f64>,
}

impl From<f64> for Approach {
    /// A normal impact.
    fn from(speed: f64) -> Self {
        Self { normal: speed, tangential: TangentialMotion::in_plane(0.0, 0.0), friction: None }
    }
}

impl Approach {
    /// From the magnitude of the velocity, its angle \[rad\] from the normal, and the spin \[rad/s\] of rolling forward.
    #[inline]
    pub fn at_angle(speed: f64, angle: f64, spin: f64, friction: f64) -> Self {
        let (sin, cos) = sin_cos(angle);
        let tangential = TangentialMotion::in_plane(speed * sin, spin);
        Self { normal: speed * cos, tangential, friction: Some(friction) }
    }

    /// The magnitude of the velocity \[m/s\].
    pub fn speed(&self) -> f64 {
        let tangential = self.tangential.signed_speed();
        if tangential == 0.0 { self.normal } else { hypot(self.normal, tangential) }
    }

    /// The angle of the velocity from the normal \[rad\].
    pub fn angle(&self) -> f64 {
        atan2(self.tangential.signed_speed(), self.normal)
    }
}
