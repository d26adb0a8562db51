//! Files of this folder.

pub mod flow;
pub mod random;
pub mod same_spot;

use crate::common::prelude::*;

/// ∫ F dt over a trace, by trapezoids.
fn impulse(trace: &[TraceRow]) -> f64 {
    trace.windows(2).map(|two| (two[1].time - two[0].time) * 0.5 * (two[0].force + two[1].force)).sum()
}
