//! Kinks of the friction within a step, where T depends on a root of time, which a step cannot pass accurately.
//!
//! ```text
//! begins to stick   springs at a stop cease to slip where their stop moves away from them: first those in the middle of the
//!                   contact or those at its rim, the others in between, and last those at the other end
//! slips as a whole  the last springs that stick are those in the middle, until they meet their stop
//! ```

use super::profile::NormalState;

/// The first kink of a step, as a share of it, that is not this `near` to an end of the step. The rims are those at its quarters,
/// M' and M those at start, middle and end. `middle` is the stretch of the spring in the middle, less M, at the start.
pub(super) fn first_kink(rims: &[NormalState; 5], motion: [[f64; 2]; 3], middle: f64, near: f64) -> Option<f64> {
    let length = rims[4].time - rims[0].time;
    let speeds = motion.map(|[speed, _]| speed);
    let shares = [1.0, -1.0].into_iter().flat_map(|side| {
        let gaps = std::array::from_fn(|i| rims[2 * i].coulomb_limit - side * (middle + motion[i][1]));
        slip_speed_excess(rims, speeds, side).into_iter().chain([gaps]).map(parabola_zero)
    });
    let is_far = |share: &f64| share.min(1.0 - share) * length > near;
    shares.flatten().filter(is_far).min_by(f64::total_cmp)
}

/// The share of a step up to which springs that slip to this side go on slipping: 1 if they do so to its end. It is 0 where the stops
/// move away faster than the springs slip at the start, as behind a joint of the law. The slopes at the start of a step to the
/// separation are not accurate, because α² may end there as a root of time.
pub(super) fn sliding_share(rims: &[NormalState; 5], speeds: [f64; 3], side: f64, is_last: bool) -> f64 {
    let until = |closing: [f64; 3]| match closing.map(|excess| excess < 0.0) {
        [true, ..] if !is_last => 0.0,
        [_, false, false] => 1.0,
        _ => parabola_zero(closing).unwrap_or(0.0),
    };
    slip_speed_excess(rims, speeds, side).map(until).into_iter().fold(1.0, f64::min)
}

/// How much faster the springs in the middle and at the rim slip to this side than their stops move away, times the length of
/// the step; at start, middle and end.
fn slip_speed_excess(rims: &[NormalState; 5], speeds: [f64; 3], side: f64) -> [[f64; 3]; 2] {
    let length = rims[4].time - rims[0].time;
    let of_middle = slopes_of_five(rims.map(|rim| rim.coulomb_limit));
    let of_square = slopes_of_five(rims.map(|rim| rim.square));
    let of_rim: [f64; 3] = std::array::from_fn(|i| {
        let NormalState { coulomb_limit: stop, square, .. } = rims[2 * i];
        if square > 0.0 { stop * of_square[i] / square } else { of_middle[i] }
    });
    [of_middle, of_rim].map(|stops| std::array::from_fn(|i| side * speeds[i] * length - stops[i]))
}

/// The slopes of the parabola through values at start, middle and end, over a step of length 1.
pub(super) fn parabola_slopes([a, b, c]: [f64; 3]) -> [f64; 3] {
    [4.0 * b - 3.0 * a - c, c - a, a - 4.0 * b + 3.0 * c]
}

/// The slopes at start, middle and end of the polynomial through values at the quarters of a step of length 1.
fn slopes_of_five([a, b, c, d, e]: [f64; 5]) -> [f64; 3] {
    let at_end = |a: f64, b: f64, c: f64, d: f64, e: f64| (25.0 * e - 48.0 * d + 36.0 * c - 16.0 * b + 3.0 * a) / 3.0;
    [-at_end(e, d, c, b, a), (8.0 * (d - b) - (e - a)) / 3.0, at_end(a, b, c, d, e)]
}

/// Where values at start, middle and end of a step of length 1 fall through 0: on the parabola through them.
fn parabola_zero(values: [f64; 3]) -> Option<f64> {
    let [a, b, c] = values;
    let half = if a > 0.0 && b < 0.0 { 0.0 } else { 0.5 };
    let [from, to] = if half == 0.0 { [a, b] } else { [b, c] };
    if !(from > 0.0 && to < 0.0) {
        return None;
    }
    let ([slope, ..], curve) = (parabola_slopes(values), 2.0 * (a - 2.0 * b + c));
    let mut share = half + 0.5 * from / (from - to);
    for _ in 0..3 {
        share -= (a + share * (slope + share * curve)) / (slope + 2.0 * share * curve);
    }
    Some(share.clamp(half, half + 0.5))
}
