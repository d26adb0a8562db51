//! The exact motion on a piece, behind the same seam as the steppers: harmonic on a straight line, an incomplete beta
//! function on a power law, quadrature on any other. For traces without integration error, and as the reference of all others.

use super::{IntegrationError, Integrator, Landing, Leg, Path, Restoring, Sampler, State, Work};
use crate::math::functions::{atan, pow, sin, sin_cos};
use crate::math::power::{power_state, power_time, quarter_period};
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
        mut samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        let (begun, loss, start) = (state.time, state.loss, *state);
        let mut take = |end: f64, at: &dyn Fn(f64) -> (f64, f64)| {
            if let Some(samples) = samples.as_deref_mut() {
                while let Some(time) = samples.due_before(end) {
                    let (distance, speed) = at(time - begun);
                    samples.take(State { time, distance, speed, loss });
                }
            }
        };
        let (landing, end) = match (path.restoring, path.leg) {
            (Restoring::Straight { at_start, slope }, leg) => {
                let omega = slope.sqrt();
                let pull = at_start + slope * start.distance;
                let at = |t: f64| {
                    let half = sin(0.5 * omega * t);
                    let (sin, cos) = sin_cos(omega * t);
                    let moved = start.speed / omega * sin - 2.0 * pull / slope * half * half;
                    (start.distance + moved, start.speed * cos - pull / omega * sin)
                };
                let to_end = match leg {
                    Leg::Outward(end) | Leg::Back(end) => end - start.distance,
                };
                let left = start.speed * start.speed - to_end * (2.0 * pull + slope * to_end);
                let (landing, moved, exit) = if left > 0.0 && left.is_finite() {
                    (Landing::End, to_end, to_end.signum() * left.sqrt())
                } else {
                    let square = start.speed * start.speed;
                    (Landing::Turning, square / (pull + (pull * pull + slope * square).sqrt()), 0.0)
                };
                // x_2 − x_1 = (u_1 + u_2) tan(ωt/2)/ω
                let lasted = 2.0 / omega * atan(omega * moved / (start.speed + exit));
                take(begun + lasted, &at);
                (landing, State { time: begun + lasted, distance: start.distance + moved, speed: exit, loss })
            }
            (Restoring::Power { coefficient, exponent }, Leg::Outward(end)) => {
                let potential =
                    |d: f64| coefficient * crate::math::power::power(d, exponent) * d * 2.0 / (exponent + 1.0);
                // as if it had come from d = 0
                let whole = start.speed * start.speed + potential(start.distance);
                let entry = whole.sqrt();
                let farthest = pow(0.5 * (exponent + 1.0) / coefficient * whole, 1.0 / (exponent + 1.0));
                let before = power_time(exponent, start.distance, entry, start.speed);
                take_power(
                    &mut take,
                    exponent,
                    farthest,
                    entry,
                    before,
                    end,
                    &start,
                    whole - potential(end.min(farthest)),
                )
            }
            (Restoring::Power { exponent, coefficient }, Leg::Back(_)) => {
                let farthest = start.distance;
                let exit = (coefficient * crate::math::power::power(farthest, exponent) * farthest * 2.0
                    / (exponent + 1.0))
                    .sqrt();
                let lasted = quarter_period(exponent) * farthest / exit;
                take(begun + lasted, &|t| {
                    let (distance, speed) = power_state(exponent, farthest, exit, lasted - t);
                    (distance, -speed)
                });
                (Landing::End, State { time: begun + lasted, distance: 0.0, speed: -exit, loss })
            }
            (Restoring::Smooth { force, start: x, factor: c }, leg) => {
                let way = SmoothWay { force, start: x, c };
                let (from, begin) = (start.distance, start.speed);
                let square = |d: f64| begin * begin - 2.0 * c * force.work(x, from, d);
                match leg {
                    Leg::Outward(end) if end.is_finite() && square(end) > 0.0 => {
                        let exit = square(end).sqrt();
                        let lasted = force.time(x, from, end, exit, c);
                        take(begun + lasted, &|t| way.before_end(from, end, t, &|d| square(d).max(0.0).sqrt()));
                        (Landing::End, State { time: begun + lasted, distance: end, speed: exit, loss })
                    }
                    Leg::Outward(_) => {
                        let so_far = force.work(x, 0.0, from);
                        // as on a straight line from x = 0 so far: it only starts the search
                        let before = 0.5 * x * force.value(x, 0.0);
                        let farthest = force.distance_at_work(x, before, so_far + 0.5 * begin * begin / c);
                        let lasted = force.time(x, from, farthest, 0.0, c);
                        take(begun + lasted, &|t| way.near_rest(from, farthest, lasted - t));
                        (Landing::Turning, State { time: begun + lasted, distance: farthest, speed: 0.0, loss })
                    }
                    Leg::Back(_) => {
                        let exit = (2.0 * c * force.work(x, 0.0, from)).sqrt();
                        let lasted = force.time(x, 0.0, from, 0.0, c);
                        take(begun + lasted, &|t| {
                            let (distance, speed) = way.near_rest(0.0, from, t);
                            (distance, -speed)
                        });
                        (Landing::End, State { time: begun + lasted, distance: 0.0, speed: -exit, loss })
                    }
                }
            }
        };
        *state = end;
        Ok(landing)
    }

    fn work(&self) -> Work {
        Work::default()
    }
}

/// A smooth force on the way: states at times, by Newton's method on the time integral.
struct SmoothWay {
    force: Smooth,
    start: f64,
    c: f64,
}

impl SmoothWay {
    /// Distance and speed at `time` after rest at `farthest` (or before it): the time is almost straight in the root of
    /// the way.
    fn near_rest(&self, lowest: f64, farthest: f64, time: f64) -> (f64, f64) {
        let Self { force, start, c } = *self;
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
    fn before_end(&self, from: f64, end: f64, time: f64, speed: &dyn Fn(f64) -> f64) -> (f64, f64) {
        let Self { force, start, c } = *self;
        let d = kept_between((from, end), end, 1e-15 * end, |d| {
            (force.time(start, from, d, speed(d), c) - time) * speed(d)
        });
        (d, speed(d))
    }
}

/// Outward on a power law: to `end`, or to the `farthest` point if that is nearer.
#[allow(clippy::too_many_arguments)]
fn take_power(
    take: &mut impl FnMut(f64, &dyn Fn(f64) -> (f64, f64)),
    exponent: f64,
    farthest: f64,
    entry: f64,
    before: f64,
    end: f64,
    start: &State,
    left: f64,
) -> (Landing, State) {
    let (landing, distance, speed) =
        if end < farthest && left > 0.0 { (Landing::End, end, left.sqrt()) } else { (Landing::Turning, farthest, 0.0) };
    let time = start.time + power_time(exponent, distance, entry, speed) - before;
    take(time, &|t| power_state(exponent, farthest, entry, before + t));
    (landing, State { time, distance, speed, loss: start.loss })
}
