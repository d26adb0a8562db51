//! Where friction has a kink inside of a step: there T goes with the root of time, which no step passes well.
//!
//! ```text
//! begins to stick   springs at a stop cease to slip where their stop moves away from them: first those in the middle of the
//!                   contact or those at its rim, the others in between, and last those at the other end
//! slips as a whole  the last springs that stick are those in the middle, until they meet their stop
//! ```

use super::profile::Rim;

/// The first kink of a step, as a share of it, that is not this `near` to an end of the step. The rims, and M' and M, are those
/// at start, middle and end. `middle` is the stretch of the spring in the middle, less M, at the start.
pub(super) fn kink(rims: [Rim; 3], motion: [[f64; 2]; 3], middle: f64, near: f64) -> Option<f64> {
    let length = rims[2].time - rims[0].time;
    let of_middle = slopes(rims.map(|rim| rim.stop));
    let of_square = slopes(rims.map(|rim| rim.square));
    let of_rim: [f64; 3] = std::array::from_fn(|i| {
        let Rim { stop, square, .. } = rims[i];
        if square > 0.0 { stop * of_square[i] / square } else { of_middle[i] }
    });
    let shares = [1.0, -1.0].into_iter().flat_map(|side| {
        let closes = |stops: [f64; 3]| std::array::from_fn(|i| side * motion[i][0] * length - stops[i]);
        let gaps = std::array::from_fn(|i| rims[i].stop - side * (middle + motion[i][1]));
        [closes(of_middle), closes(of_rim), gaps].map(falls_through)
    });
    let is_far = |share: &f64| share.min(1.0 - share) * length > near;
    shares.flatten().filter(is_far).min_by(f64::total_cmp)
}

/// The slopes of the parabola through values at start, middle and end, over a step of length 1.
fn slopes([a, b, c]: [f64; 3]) -> [f64; 3] {
    [4.0 * b - 3.0 * a - c, c - a, a - 4.0 * b + 3.0 * c]
}

/// Where values at start, middle and end of a step of length 1 fall through 0: on the parabola through them.
fn falls_through(values: [f64; 3]) -> Option<f64> {
    let [a, b, c] = values;
    let half = if a > 0.0 && b < 0.0 { 0.0 } else { 0.5 };
    let [from, to] = if half == 0.0 { [a, b] } else { [b, c] };
    if !(from > 0.0 && to < 0.0) {
        return None;
    }
    let ([slope, ..], curve) = (slopes(values), 2.0 * (a - 2.0 * b + c));
    let mut share = half + 0.5 * from / (from - to);
    for _ in 0..3 {
        share -= (a + share * (slope + share * curve)) / (slope + 2.0 * share * curve);
    }
    Some(share.clamp(half, half + 0.5))
}
