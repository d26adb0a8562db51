//! The motion of a sphere along the surface, and its spin.
//!
//! ```text
//! axes   x along the surface in the direction of the path, z out of the half-space, y = z × x: to the left, seen from above
//! spin   about +y: the sphere rolls forward;   about +x: the contact point slips to the left, and friction drives the sphere to the right
//! ```

use crate::numerics::functions::{atan2, hypot};

/// Tangential velocity and spin of a sphere. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentialMotion {
    /// v_x \[m/s\]; negative backwards.
    pub speed: f64,
    /// Ω_y \[rad/s\]; positive for rolling forward.
    pub spin: f64,
    /// The motion out of the plane of incidence. `None` for an impact that has none and does not report it.
    pub cross: Option<CrossMotion>,
}

/// The motion out of the plane of incidence. SI units.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CrossMotion {
    /// v_y \[m/s\]; positive to the left, seen from above.
    pub speed: f64,
    /// Ω_x \[rad/s\], about the direction of the path.
    pub spin_about_path: f64,
    /// Ω_z \[rad/s\], about the normal out of the half-space.
    pub spin_about_normal: f64,
}

impl TangentialMotion {
    /// A motion in the plane of incidence.
    pub const fn in_plane(speed: f64, spin: f64) -> Self {
        Self { speed, spin, cross: None }
    }

    /// The tangential velocity \[m/s\].
    pub fn velocity(&self) -> [f64; 2] {
        [self.speed, self.cross.map_or(0.0, |cross| cross.speed)]
    }

    /// The spins about x, y and z \[rad/s\].
    pub fn spins(&self) -> [f64; 3] {
        let CrossMotion { spin_about_path, spin_about_normal, .. } = self.cross.unwrap_or_default();
        [spin_about_path, self.spin, spin_about_normal]
    }

    /// The azimuth of the tangential velocity \[rad\], from x to y; NaN without a tangential velocity.
    pub fn azimuth(&self) -> f64 {
        let [x, y] = self.velocity();
        if x == 0.0 && y == 0.0 { f64::NAN } else { atan2(y, x) }
    }

    /// The tangential speed \[m/s\]: in the plane of incidence negative backwards; out of the plane, where the azimuth states the
    /// direction, the magnitude.
    pub(super) fn signed_speed(&self) -> f64 {
        self.cross.map_or(self.speed, |cross| hypot(self.speed, cross.speed))
    }

    /// The kinetic energy \[J\] of a sphere with this mass \[kg\] and this moment of inertia \[kg m²\].
    pub(super) fn kinetic_energy(&self, mass: f64, moment: f64) -> f64 {
        let Self { speed, spin, cross } = self;
        let in_plane = 0.5 * (mass * speed * speed + moment * spin * spin);
        let out_of_plane = |cross: CrossMotion| {
            let CrossMotion { speed, spin_about_path: path, spin_about_normal: normal } = cross;
            0.5 * (mass * speed * speed + moment * (path * path + normal * normal))
        };
        in_plane + cross.map_or(0.0, out_of_plane)
    }

    /// The motion after a change of the tangential velocity \[m/s\] along a direction, and of the spin \[rad/s\] about z × direction.
    pub(super) fn with_change(&self, direction: [f64; 2], velocity: f64, spin: f64) -> Self {
        let [x, y] = direction;
        Self {
            speed: self.speed + velocity * x,
            spin: self.spin + spin * x,
            cross: self.cross.map(|cross| CrossMotion {
                speed: cross.speed + velocity * y,
                spin_about_path: cross.spin_about_path - spin * y,
                ..cross
            }),
        }
    }
}
