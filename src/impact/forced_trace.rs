//! Points of a trace under gravity and damping, and what collects them.

use super::course::{Event, loaded};
use super::scales::ACCELERATION;
use crate::integrate::forced::{Drag, ForcedState};
use crate::integrate::{Sampler, State};
use crate::law::{Law, Peak, Unloading};
use crate::power::max_or_nan;

/// A point of a trace, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForcedPoint {
    /// Time, x and u.
    pub state: State,
    /// Force of the law.
    pub force: f64,
    /// With damping.
    pub total_force: f64,
    /// ε.
    pub elastic_approach: f64,
    /// What damping has taken so far, in units of Φ L.
    pub loss: f64,
    /// Whether compression is over.
    pub is_unloading: bool,
    /// The event, if it is one.
    pub event: Option<Event>,
}

/// Collects a trace: even samples in time and every event.
#[derive(Debug, Clone, Default)]
pub struct ForcedRecorder {
    pub(super) sampler: Sampler,
    /// The points in order of time.
    pub points: Vec<ForcedPoint>,
}

impl ForcedRecorder {
    /// A recorder of `samples` points evenly spaced over `duration`, both ends included (they are events).
    #[must_use]
    pub fn new(samples: usize, duration: f64) -> Self {
        let inner = samples.saturating_sub(2);
        #[allow(clippy::cast_precision_loss)]
        let interval = duration / (inner + 1) as f64;
        Self { sampler: Sampler::every(interval, inner), points: Vec::with_capacity(samples + 16) }
    }

    /// Turns the samples of a leg, and the event at its end, into points.
    pub(super) fn take(&mut self, leg: &On, event: Option<(Event, &ForcedState)>) {
        let states = std::mem::take(&mut self.sampler.states);
        let losses = std::mem::take(&mut self.sampler.losses);
        let sampled =
            states.iter().zip(&losses).map(|(state, loss)| leg.point(&ForcedState { state: *state, loss: *loss }));
        self.points.extend(sampled);
        self.points.extend(event.map(|(event, at)| ForcedPoint { event: Some(event), ..leg.point(at) }));
    }
}

/// What drag adds to the force of the law, in units of Φ, where the law has this force and slope. A formula may slope down by
/// its rounding where it should be level: it is level there.
pub(super) fn drag_force(drag: Drag, force: f64, slope: f64, speed: f64) -> f64 {
    match drag {
        Drag::None => 0.0,
        Drag::OfForce(chi) => force * chi * speed,
        Drag::OfStiffness(eta) => eta * (max_or_nan(slope, 0.0) / ACCELERATION).sqrt() * speed,
    }
}

/// A branch of the law that points lie on.
pub(super) enum On<'a> {
    Piece { law: &'a Law, index: usize, drag: Drag },
    Unloading { unloading: &'a Unloading, drag: Drag },
}

impl On<'_> {
    /// `at.state.distance` is from the zero of a power law, from the start of a straight piece, or from the residual
    /// indentation.
    pub(super) fn point(&self, at: &ForcedState) -> ForcedPoint {
        let State { time, distance, speed } = at.state;
        let (x, force, slope, elastic_approach, drag, is_unloading) = match *self {
            Self::Piece { law, index, drag } => {
                let Peak { indentation, force, elastic_approach } = loaded(law, index, distance);
                let piece = &law.loading.pieces()[index];
                let slope = piece.slope_beyond(distance - piece.shape.lead());
                (indentation, force, slope, elastic_approach, drag, false)
            }
            Self::Unloading { unloading, drag } => {
                let recovered = distance.max(0.0);
                let (force, slope) = (unloading.force_after(recovered), unloading.slope_after(recovered));
                (unloading.peak.residual() + distance, force, slope, distance, drag, true)
            }
        };
        let state = State { time, distance: x, speed };
        // where it lifts off the total is zero up to rounding
        let total_force = max_or_nan(force + drag_force(drag, force, slope, speed), 0.0);
        let loss = at.loss / ACCELERATION;
        ForcedPoint { state, force, total_force, elastic_approach, loss, is_unloading, event: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_below_zero_by_rounding_damps_nothing_and_one_that_is_no_number_stays_so() {
        let viscous = Drag::OfStiffness(0.2);
        assert_eq!(drag_force(viscous, 1.0, -1e-17, 3.0), 0.0);
        assert!(drag_force(viscous, 1.0, f64::NAN, 3.0).is_nan());
        // 2 ζ √((4/5) df/dx) u
        assert_eq!(drag_force(viscous, 1.0, 1.25, 3.0), 0.2 * 3.0);
    }
}
