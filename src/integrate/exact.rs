//! The exact motion on a piece as an [`Integrator`]: harmonic on a straight line, an incomplete beta function on a power law,
//! a quadrature on any other. It serves traces without integration error, and is the reference of the other integrators.

use super::{Arrival, IntegrationError, Integrator, Landing, Leg, Path, Restoring, Segment, State, Work};
use crate::math::functions::{atan, pow, sin, sin_cos};
use crate::math::power::{power, power_state, power_time, quarter_period};
use crate::math::root::kept_between;
use crate::math::smooth::Smooth;

/// Energy and closed-form times instead of steps, for ways that only the restoring force acts on.
#[derive(Debug, Clone, Default)]
pub struct Exact;

impl Integrator for Exact {
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        track: Option<&mut Vec<Segment>>,
    ) -> Result<Arrival, IntegrationError> {
        let start = *state;
        let (landing, end, at) = match (path.restoring, path.leg) {
            (Restoring::Straight { at_start, slope }, leg) => straight(start, leg, at_start, slope),
            (Restoring::Power { coefficient, exponent }, Leg::Outward(end)) => {
                power_outward(start, end, coefficient, exponent)
            }
            (Restoring::Power { coefficient, exponent }, Leg::Back(_)) => power_back(start, coefficient, exponent),
            (Restoring::Smooth { force, start: x, factor: c }, leg) => {
                SmoothWay { force, start: x, c }.along(start, leg)
            }
        };
        if let Some(track) = track {
            track.push(Segment::new(end.time, move |time| {
                let (distance, speed) = at(time - start.time);
                State { time, distance, speed, ..start }
            }));
        }
        *state = end;
        Ok(Arrival { landing, largest_force: path.larger_force(&start, state) })
    }

    fn work(&self) -> Work {
        Work::default()
    }
}

/// Distance and speed at a time since the start of a leg.
type At = Box<dyn Fn(f64) -> (f64, f64)>;
/// Where a leg ends, the state there, and those on the way.
type Way = (Landing, State, At);

fn straight(start: State, leg: Leg, at_start: f64, slope: f64) -> Way {
    let omega = slope.sqrt();
    let pull = at_start + slope * start.distance;
    let to_end = leg.end() - start.distance;
    let square = start.speed * start.speed;
    let left = square - to_end * (2.0 * pull + slope * to_end);
    let (landing, moved, exit) = if left > 0.0 && left.is_finite() {
        (Landing::End, to_end, to_end.signum() * left.sqrt())
    } else {
        (Landing::Turning, square / (pull + (pull * pull + slope * square).sqrt()), 0.0)
    };
    // x_2 − x_1 = (u_1 + u_2) tan(ωt/2)/ω
    let time = start.time + 2.0 / omega * atan(omega * moved / (start.speed + exit));
    let at = move |t: f64| {
        let half = sin(0.5 * omega * t);
        let (sin, cos) = sin_cos(omega * t);
        let moved = start.speed / omega * sin - 2.0 * pull / slope * half * half;
        (start.distance + moved, start.speed * cos - pull / omega * sin)
    };
    (landing, State { time, distance: start.distance + moved, speed: exit, ..start }, Box::new(at))
}

/// To `end`, or to the turning point if that is nearer.
fn power_outward(start: State, end: f64, coefficient: f64, exponent: f64) -> Way {
    let potential = |d: f64| coefficient * power(d, exponent) * d * 2.0 / (exponent + 1.0);
    // as if it had come from d = 0
    let whole = start.speed * start.speed + potential(start.distance);
    let entry = whole.sqrt();
    let farthest = pow(0.5 * (exponent + 1.0) / coefficient * whole, 1.0 / (exponent + 1.0));
    let before = power_time(exponent, start.distance, entry, start.speed);
    let left = whole - potential(end.min(farthest));
    let (landing, distance, speed) =
        if end < farthest && left > 0.0 { (Landing::End, end, left.sqrt()) } else { (Landing::Turning, farthest, 0.0) };
    let time = start.time + power_time(exponent, distance, entry, speed) - before;
    let at = move |t| power_state(exponent, farthest, entry, before + t);
    (landing, State { time, distance, speed, ..start }, Box::new(at))
}

fn power_back(start: State, coefficient: f64, exponent: f64) -> Way {
    let farthest = start.distance;
    let exit = (coefficient * power(farthest, exponent) * farthest * 2.0 / (exponent + 1.0)).sqrt();
    let lasted = quarter_period(exponent) * farthest / exit;
    let at = move |t| {
        let (distance, speed) = power_state(exponent, farthest, exit, lasted - t);
        (distance, -speed)
    };
    (Landing::End, State { time: start.time + lasted, distance: 0.0, speed: -exit, ..start }, Box::new(at))
}

/// A smooth force on the way: states at times, by Newton's method on the time integral.
#[derive(Clone, Copy)]
struct SmoothWay {
    force: Smooth,
    start: f64,
    c: f64,
}

impl SmoothWay {
    fn along(self, begun: State, leg: Leg) -> Way {
        let Self { force, start, c } = self;
        let State { distance: from, speed: begin, .. } = begun;
        let square = move |d: f64| begin * begin - 2.0 * c * force.work(start, from, d);
        let (landing, lasted, distance, speed, at): (_, _, _, _, At) = match leg {
            Leg::Outward(end) if end.is_finite() && square(end) > 0.0 => {
                let exit = square(end).sqrt();
                let at = move |t| self.before_end(from, end, t, &|d| square(d).max(0.0).sqrt());
                (Landing::End, force.time(start, from, end, exit, c), end, exit, Box::new(at))
            }
            Leg::Outward(_) => {
                let so_far = force.work(start, 0.0, from);
                // the work so far as on a straight line from x = 0: it only starts the search
                let before = 0.5 * start * force.value(start, 0.0);
                let farthest = force.distance_at_work(start, before, so_far + 0.5 * begin * begin / c);
                let lasted = force.time(start, from, farthest, 0.0, c);
                (Landing::Turning, lasted, farthest, 0.0, Box::new(move |t| self.near_rest(from, farthest, lasted - t)))
            }
            Leg::Back(_) => {
                let exit = (2.0 * c * force.work(start, 0.0, from)).sqrt();
                let at = move |t| {
                    let (distance, speed) = self.near_rest(0.0, from, t);
                    (distance, -speed)
                };
                (Landing::End, force.time(start, 0.0, from, 0.0, c), 0.0, -exit, Box::new(at))
            }
        };
        (landing, State { time: begun.time + lasted, distance, speed, ..begun }, at)
    }

    /// Distance and speed at `time` after rest at `farthest` (or before it): the time is almost straight in the root of
    /// the way.
    fn near_rest(self, lowest: f64, farthest: f64, time: f64) -> (f64, f64) {
        let Self { force, start, c } = self;
        let speed = |d: f64| (2.0 * c * force.work(start, d, farthest)).max(0.0).sqrt();
        let deepest = (farthest - lowest).sqrt();
        let first = (time * (0.5 * c * force.value(start, farthest)).sqrt()).min(deepest);
        let root = kept_between((0.0, deepest), first, 1e-15 * deepest, |root| {
            let d = farthest - root * root;
            (force.time(start, d, farthest, 0.0, c) - time) * speed(d) / (2.0 * root)
        });
        let d = farthest - root * root;
        (d, speed(d))
    }

    /// Distance and speed at `time` after leaving `from` on the way to `end`; the time is convex in the distance.
    fn before_end(self, from: f64, end: f64, time: f64, speed: &dyn Fn(f64) -> f64) -> (f64, f64) {
        let Self { force, start, c } = self;
        let d = kept_between((from, end), end, 1e-15 * end, |d| {
            (force.time(start, from, d, speed(d), c) - time) * speed(d)
        });
        (d, speed(d))
    }
}
