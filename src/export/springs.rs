//! Springs that replace the law at one speed, and the range of speeds in which they may.

use std::f64::consts::PI;

use super::request::Equal;
use crate::impact::{Contact, Impact};
use crate::math::functions::{cos, exp, ln, sin};
use crate::math::root::halved;

/// Largest relative error of a constant e within its range of speeds.
pub const E_WITHIN: f64 = 0.02;

/// With this many steps of velocity Verlet per contact, e of a damped spring is accurate to 0.5 %. The damping uses the
/// speed of half a step before, which is an error of first order in the step.
pub const STEPS_PER_CONTACT: f64 = 200.0;

/// Stiffnesses of the springs that replace the law at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// Stiffness of the damped linear spring \[N/m\].
    pub damped: f64,
    /// Stiffness k₁ of the two springs, for loading \[N/m\].
    pub loading: f64,
    /// Stiffness k₂ of the two springs, for unloading \[N/m\].
    pub unloading: f64,
}

impl Springs {
    /// The springs for an impact.
    pub fn of(contact: &Contact, impact: &Impact, equal: Equal) -> Self {
        let (mass, e, time) = (contact.mass(), impact.restitution, impact.contact_time);
        let root = match equal {
            Equal::ContactTime => PI * (1.0 + e) / (2.0 * time),
            Equal::PeakForce => impact.peak_force / (mass * impact.speed),
        };
        let loading = mass * root * root;
        let decrement = ln(e);
        let damped = mass * (PI * PI + decrement * decrement) / (time * time);
        Self { damped, loading, unloading: loading / (e * e) }
    }
}

/// Stiffness \[N/m\] and damping \[N s/m\] of a damped spring that never pulls and has this e and this duration of the
/// force. `None` if no such spring below critical damping has this e.
pub fn spring_without_pull(mass: f64, e: f64, time: f64) -> Option<(f64, f64)> {
    let loss = -ln(e);
    let (angle, _) = halved(0.0, 0.5 * PI, |angle| sin(angle) / cos(angle) * (PI - 2.0 * angle) < loss);
    let frequency = (PI - 2.0 * angle) / (time * cos(angle));
    (loss < 2.0).then(|| (mass * frequency * frequency, 2.0 * mass * frequency * sin(angle)))
}

/// The range of speeds around `speed` in which e differs from its value at `speed` by at most [`E_WITHIN`]. Each end is
/// searched up to a factor of 1000.
pub fn range_of_constant(contact: &Contact, speed: f64, e: f64) -> (f64, f64) {
    let is_near = |factor: f64| {
        let other = contact.closed_form(speed * factor).map_or(f64::NAN, |impact| impact.restitution);
        (other / e - 1.0).abs() <= E_WITHIN
    };
    let end = |sign: f64| exp(sign * halved(0.0, ln(1000.0), |log| is_near(exp(sign * log))).0);
    (speed * end(-1.0), speed * end(1.0))
}
