//! Springs that stand for the law at one speed, and how far from it.

use std::f64::consts::PI;

use super::request::Equal;
use crate::impact::{Contact, Impact};
use crate::math::functions::{cos, exp, ln, sin};
use crate::math::root::halved;

/// What a constant e may be off before its range of speeds ends.
pub const E_WITHIN: f64 = 0.02;

/// Steps of velocity Verlet per contact that keep e of a damped spring within 0.5 %: its damping is that of half a step
/// before, an error of first order in the step.
pub const STEPS_PER_CONTACT: f64 = 200.0;

/// Springs that stand for the law at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// Of the damped linear spring \[N/m\].
    pub damped: f64,
    /// k₁ of the two springs, loading \[N/m\].
    pub loading: f64,
    /// k₂ of the two springs, unloading \[N/m\].
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

/// Stiffness \[N/m\] and damping \[N s/m\] of a damped spring that never pulls, with this e and duration of the force;
/// `None` for an e that no such spring has below critical damping.
pub fn spring_without_pull(mass: f64, e: f64, time: f64) -> Option<(f64, f64)> {
    let loss = -ln(e);
    let (angle, _) = halved(0.0, 0.5 * PI, |angle| sin(angle) / cos(angle) * (PI - 2.0 * angle) < loss);
    let frequency = (PI - 2.0 * angle) / (time * cos(angle));
    (loss < 2.0).then(|| (mass * frequency * frequency, 2.0 * mass * frequency * sin(angle)))
}

/// The speeds around `speed` at which e is within [`E_WITHIN`] of its value there; no end is searched beyond a factor 1000.
pub fn range_of_constant(contact: &Contact, speed: f64, e: f64) -> (f64, f64) {
    let is_near = |factor: f64| {
        let other = contact.closed_form(speed * factor).map_or(f64::NAN, |impact| impact.restitution);
        (other / e - 1.0).abs() <= E_WITHIN
    };
    let end = |sign: f64| exp(sign * halved(0.0, ln(1000.0), |log| is_near(exp(sign * log))).0);
    (speed * end(-1.0), speed * end(1.0))
}
