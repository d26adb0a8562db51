//! Loading laws that are printed piece by piece, where the force jumps from one piece to the next.

use crate::math::root::halved;
use crate::units::names::named;

named! {
    /// How the jumps of a force that was printed piece by piece are treated.
    #[derive(Default)]
    pub enum Jumps {
        /// Kept, at the printed limits.
        #[default]
        Printed = "printed",
        /// Removed: every piece goes on until the next one crosses it.
        Crossed = "crossed",
    }
}

/// The place where an excess that is positive at `from` falls to zero, by bisection. `None` if it is not positive at `from`, or
/// not zero before `until`.
pub(super) fn crossing(excess: impl Fn(f64) -> f64, from: f64, until: f64) -> Option<f64> {
    /// Steps of the search.
    const GROWTH: f64 = 1.02;
    let mut high = from;
    while excess(high) > 0.0 {
        high *= GROWTH;
        if high.is_nan() || high >= GROWTH * until {
            return None;
        }
    }
    if high == from {
        return None;
    }
    Some(halved(high / GROWTH, high, |x| excess(x) > 0.0).1)
}
