//! One contact of another code, by the equation of that code, in dimensionless form: e and the contact time. The parameters of an
//! export are those at which this equation gives e and contact time of the law.

use std::f64::consts::PI;

use crate::numerics::functions::{exp, ln};

/// Steps of the method of Runge and Kutta per unit of time. A contact takes about three units: errors are below 1e-7.
const STEPS_PER_UNIT: f64 = 1000.0;
/// A contact that takes longer does not end.
const MAX_TIME: f64 = 1000.0;

/// e, and the time until the overlap or the force ends, of x'' = −f(x, x') from x = 0 with the speed 1. A force below zero is zero, as in the
/// codes that never pull: the sphere then leaves with the speed that it has.
pub(super) fn restitution_and_time(force: impl Fn(f64, f64) -> f64) -> (f64, f64) {
    let h = 1.0 / STEPS_PER_UNIT;
    let acceleration = |x: f64, u: f64| if x > 0.0 { -force(x, u).max(0.0) } else { 0.0 };
    let (mut x, mut u, mut time) = (0.0, 1.0, 0.0);
    while time < MAX_TIME {
        let (k1, l1) = (u, acceleration(x, u));
        let (k2, l2) = (u + 0.5 * h * l1, acceleration(x + 0.5 * h * k1, u + 0.5 * h * l1));
        let (k3, l3) = (u + 0.5 * h * l2, acceleration(x + 0.5 * h * k2, u + 0.5 * h * l2));
        let (k4, l4) = (u + h * l3, acceleration(x + h * k3, u + h * l3));
        let next = [x + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4), u + h / 6.0 * (l1 + 2.0 * (l2 + l3) + l4)];
        if next[1] < 0.0 && next[0] <= 0.0 {
            // the force is nearly zero in this step
            let share = x / (x - next[0]);
            return (-(u + share * (next[1] - u)), time + share * h);
        }
        ([x, u], time) = (next, time + h);
        if u < 0.0 && force(x, u) <= 0.0 {
            return (-u, time);
        }
    }
    (0.0, MAX_TIME)
}

/// β = −ln e/√(π² + ln² e): the damping of a Hertz contact that has this e while its force may pull.
pub(super) fn damping_ratio(e: f64) -> f64 {
    let loss = -ln(e);
    loss / (PI * PI + loss * loss).sqrt()
}

/// e of a Hertz contact with the damping β < 1, whose force may pull: the inverse of [`damping_ratio`].
pub(super) fn restitution_of_ratio(beta: f64) -> f64 {
    exp(-PI * beta / (1.0 - beta * beta).sqrt())
}

/// e and the time of a damped Hertz contact that never pulls, x^1.5 + 2 √(5/6) β √(3/2) x^(1/4) x'.
pub(super) fn damped_hertz_contact(beta: f64) -> (f64, f64) {
    let factor = 2.0 * (5.0_f64 / 6.0).sqrt() * 1.5_f64.sqrt() * beta;
    restitution_and_time(|x, u| x * x.sqrt() + factor * x.sqrt().sqrt() * u)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::functions::{asin, cos, sin};

    /// An undamped spring takes half a period, π; a damped one that never pulls has the e and the time of Schwager and Pöschel (2007).
    #[test]
    fn springs_have_closed_forms_of_restitution_and_time() {
        let (e, time) = restitution_and_time(|x, _| x);
        assert!((e - 1.0).abs() < 1e-6 && (time - PI).abs() < 1e-5, "{e} {time}");
        let damping = 0.4_f64;
        let (e, time) = restitution_and_time(|x, u| x + damping * u);
        let angle = asin(0.5 * damping);
        let closed = exp(-sin(angle) / cos(angle) * (PI - 2.0 * angle));
        assert!((e / closed - 1.0).abs() < 1e-3, "{e} {closed}");
        assert!((time * cos(angle) / (PI - 2.0 * angle) - 1.0).abs() < 2e-3, "{time}");
    }
}
