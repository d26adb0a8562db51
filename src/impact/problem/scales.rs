//! Dimensionless variables, and the factors from them to SI units.
//!
//! x = δ/L, f = F/Φ, u = δ'/V, τ = t V/L with ½ m V² = (2/5) Φ L, so that the equation of motion is x'' = −(5/4) f for
//! every sphere. L, Φ, V are the yield indentation, force and speed. An impact that stays elastic uses its Hertz peak and its speed
//! instead, so that the slowest impact is no closer to underflow than the fastest.

use crate::contact::body::{OutOfFloatRange, finite_positive};
use crate::contact::pair::Pair;
use crate::numerics::functions::pow;
use crate::numerics::power::power_turning_distance;

/// c of x'' = −c f. Every other factor of the dimensionless motion follows from it.
pub const FORCE_FACTOR: f64 = 1.25;

/// √c, so that ω = √c √s on a straight piece of slope s.
pub(in crate::impact) const SQRT_FORCE_FACTOR: f64 = 1.118_033_988_749_895;

/// The energy u²/(2c) of a dimensionless speed u, in units of Φ L.
#[inline(always)]
pub(in crate::impact) const fn kinetic_energy(speed: f64) -> f64 {
    0.5 / FORCE_FACTOR * speed * speed
}

/// The dimensionless speed √(2c E) of an energy E ≥ 0 in units of Φ L.
#[inline(always)]
pub(in crate::impact) fn speed_at_energy(energy: f64) -> f64 {
    (2.0 * FORCE_FACTOR * energy).sqrt()
}

/// The units of a contact, with or without a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// L \[m\].
    pub length: f64,
    /// Φ \[N\].
    pub force: f64,
    /// Hertz contact radius at L \[m\].
    pub contact_radius: f64,
}

impl Units {
    /// The units of first yield; for bodies without a yield strength, the units of a Hertz contact that is as deep as R.
    pub(crate) fn from_pair(pair: &Pair) -> Self {
        let Some(point) = pair.yield_point else {
            let length = pair.radius;
            return Self { length, force: pair.hertz_stiffness() * length * length.sqrt(), contact_radius: length };
        };
        Self { length: point.indentation, force: point.force, contact_radius: point.contact_radius }
    }

    /// Φ L \[J\].
    pub fn energy(&self) -> f64 {
        self.force * self.length
    }
}

/// The units of length, force and speed of one impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    pub units: Units,
    /// V \[m/s\].
    pub speed: f64,
}

impl Scales {
    /// The units of a pair, with the speed at which this mass \[kg\] has the energy Φ L/(2c): v_Y for bodies that yield.
    pub(crate) fn from_pair(pair: &Pair, mass: f64) -> Result<Self, OutOfFloatRange> {
        let units = Units::from_pair(pair);
        let speed = (1.0 / FORCE_FACTOR * (units.force / mass) * units.length).sqrt();
        let speed = if pair.yield_point.is_some() { finite_positive("yield speed (m/s)", speed)? } else { speed };
        Ok(Self { units, speed })
    }

    /// Hertz scales of an elastic impact of `mass` at `speed` under `gravity`: L where (2/5) K L^2.5 = ½ m v² + m g L,
    /// Φ = K L^1.5, and V with ½ m V² = (2/5) Φ L, which is v without gravity.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] if indentation, force or kinetic energy underflow or overflow.
    pub(crate) fn from_hertz_impact(pair: &Pair, mass: f64, speed: f64, gravity: f64) -> Result<Self, OutOfFloatRange> {
        let stiffness = pair.hertz_stiffness();
        let (square, per_stiffness) = (speed * speed, FORCE_FACTOR * mass / stiffness);
        let power = per_stiffness * square;
        let length = match gravity {
            // the root leaves the range of doubles only if the kinetic energy does
            0.0 if power.is_normal() => pow(power, 0.4),
            0.0 => pow(per_stiffness.sqrt() * speed, 0.8),
            _ => power_turning_distance(stiffness / mass, 1.5, 0.5 * square, gravity),
        };
        let length = finite_positive("peak indentation (m)", length)?;
        let force = finite_positive("peak force (N)", stiffness * length * length.sqrt())?;
        let fastest = if gravity == 0.0 { speed } else { (square + 2.0 * gravity * length).sqrt() };
        let units = Units { length, force, contact_radius: (pair.radius * length).sqrt() };
        Ok(Self { units, speed: fastest })
    }

    /// L/V \[s\].
    pub fn time(&self) -> f64 {
        self.units.length / self.speed
    }
}
