//! Springs that replace the law at one speed, and the range of speeds in which they may.

use std::f64::consts::PI;

use crate::impact::{Contact, Solver};
use crate::numerics::functions::{cos, exp, ln, sin};
use crate::numerics::root::bisect;

/// Largest relative error of a constant e within its range of speeds.
pub const MAX_RESTITUTION_ERROR: f64 = 0.02;

/// The number of steps of velocity Verlet in a contact at which e of a damped spring is accurate to 1 %, wherever in a step
/// the contact begins. The damping uses the speed half a step earlier, and the first and the last step are partly out of contact:
/// errors of first order in the step that grow with the damping, by about ln² e.
pub fn steps_per_contact(e: f64) -> f64 {
    let decrement = ln(e);
    (18.0 * decrement * decrement).ceil().max(20.0) * 10.0
}

/// Stiffness \[N/m\] of a damped linear spring with this e and this duration of the overlap.
pub fn damped_spring(mass: f64, e: f64, time: f64) -> f64 {
    let decrement = ln(e);
    mass * (PI * PI + decrement * decrement) / (time * time)
}

/// Stiffness \[N/m\] and damping \[N s/m\] of a damped spring that never pulls and has this e and this duration of the
/// force. `None` if no such spring below critical damping has this e.
pub fn non_cohesive_spring(mass: f64, e: f64, time: f64) -> Option<(f64, f64)> {
    let loss = -ln(e);
    let (angle, _) = bisect(0.0, 0.5 * PI, |angle| sin(angle) / cos(angle) * (PI - 2.0 * angle) < loss);
    let frequency = (PI - 2.0 * angle) / (time * cos(angle));
    (loss < 2.0).then(|| (mass * frequency * frequency, 2.0 * mass * frequency * sin(angle)))
}

/// The lowest and the highest speed between which e differs from its value at `speed` by at most [`MAX_RESTITUTION_ERROR`]; `None` if an
/// end is farther than a factor of 1000.
pub fn constant_restitution_range(contact: &Contact, speed: f64, e: f64) -> [Option<f64>; 2] {
    let is_near = |factor: f64| {
        let other = contact.row(speed * factor, &Solver::AUTO).map_or(f64::NAN, |row| row.measured_restitution());
        (other / e - 1.0).abs() <= MAX_RESTITUTION_ERROR
    };
    [-1.0, 1.0].map(|sign| {
        let end = ln(1000.0);
        let log = (!is_near(exp(sign * end))).then(|| bisect(0.0, end, |log| is_near(exp(sign * log))).0);
        log.map(|log| speed * exp(sign * log))
    })
}
