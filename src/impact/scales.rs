//! Dimensionless variables and the way back.
//!
//! x = δ/L, f = F/Φ, u = δ'/V, τ = t V/L with ½ m V² = (2/5) Φ L, so that the equation of motion is x'' = −(5/4) f for
//! every sphere. L, Φ, V are the yield indentation, force and speed; an impact that stays elastic takes its own Hertz peak
//! and speed instead, so that the slowest impact is no closer to underflow than the fastest.

use crate::material::{OutOfFloatRange, Pair, YieldPoint, normal};
use crate::math::functions::pow;

/// c of x'' = −c f.
pub const ACCELERATION: f64 = 1.25;

/// The units of length, force and speed of one impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// L \[m\].
    pub length: f64,
    /// Φ \[N\].
    pub force: f64,
    /// V \[m/s\].
    pub speed: f64,
    /// Hertz contact radius at L \[m\].
    pub contact_radius: f64,
}

impl Scales {
    /// Yield scales; `speed` is v_Y of the sphere.
    pub(crate) fn of_yield(point: &YieldPoint, speed: f64) -> Self {
        Self { length: point.indentation, force: point.force, speed, contact_radius: point.contact_radius }
    }

    /// Hertz scales of an elastic impact of `mass` at `speed`: L = (5 m v²/(4 K))^(2/5), Φ = K L^1.5, V = v.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where indentation, force or kinetic energy underflow or overflow.
    pub(crate) fn of_hertz(pair: &Pair, mass: f64, speed: f64) -> Result<Self, OutOfFloatRange> {
        let stiffness = pair.hertz_stiffness();
        let per_stiffness = 1.25 * mass / stiffness;
        let power = per_stiffness * (speed * speed);
        // the root leaves the range of doubles only where the kinetic energy does
        let power = if power.is_normal() { pow(power, 0.4) } else { pow(per_stiffness.sqrt() * speed, 0.8) };
        let length = normal("peak indentation (m)", power)?;
        let force = normal("peak force (N)", stiffness * length * length.sqrt())?;
        Ok(Self { length, force, speed, contact_radius: (pair.radius * length).sqrt() })
    }

    /// L/V \[s\].
    pub fn time(&self) -> f64 {
        self.length / self.speed
    }

    /// Φ L \[J\].
    pub fn energy(&self) -> f64 {
        self.force * self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::functions::ln;

    #[test]
    fn hertz_scales_balance_the_energy_up_to_the_ends_of_the_doubles() {
        // (2/5) Φ L = ½ m v²; the exponent 0.8 is a double, which moves L by ln L · 2^-54
        let pair = |radius: f64, effective_modulus: f64| Pair {
            radius,
            effective_modulus,
            sphere_compliance: 0.5,
            half_space_compliance: 0.5,
            yield_point: None,
        };
        let scenes = [
            (5e-3, 1e11, 4e-3, 3.0),
            (1e-9, 1e11, 3e-23, 100.0),
            // least and largest masses, speeds, energies
            (1e-9, 1e11, 1e-300, 100.0),
            (1e-9, 1e-200, 1e-150, 1e-75),
            (1.0, 1e11, 1.0, 1e-150),
            (1.0, 1e11, 1.0, 1e150),
            (1.0, 1e11, 1e300, 1.0),
            (1.0, 1e-150, 1e150, 1.0),
            (1.0, 1e150, 1e-150, 1.0),
        ];
        for (radius, modulus, mass, speed) in scenes {
            let scales = Scales::of_hertz(&pair(radius, modulus), mass, speed).unwrap();
            let kinetic = 0.5 * mass * speed * speed;
            let rounding = (8.0 + ln(scales.length).abs()) * f64::EPSILON;
            approx::assert_relative_eq!(0.4 * scales.energy(), kinetic, max_relative = rounding);
        }
        for speed in [0.0, 1e-300, 1e300, f64::INFINITY, f64::NAN] {
            assert!(Scales::of_hertz(&pair(1.0, 1e11), 1.0, speed).is_err(), "{speed}");
        }
    }
}
