//! The normal motion as friction needs it: the radius of the contact and the stops of its springs at any time.

use std::sync::LazyLock;

use super::profile::NormalState;
use crate::contact::law::{ContactState, Surface, UnloadingRule};
use crate::impact::problem::forces::{ScaledForces, total_force};
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::impact::scaled_impact::hertz_law;
use crate::impact::solve::motion;
use crate::impact::solve::recorder::{RecordedMotion, TracePoint, TraceRecorder};
use crate::numerics::curve::piece::Piece;
use crate::numerics::ode::IntegrationError;
use crate::numerics::ode::rk8::Rk8;
use crate::numerics::root::bisect;

/// The normal motion of an impact.
#[derive(Debug)]
pub struct NormalMotion<'a> {
    track: RecordedMotion<'a>,
    /// The unloading branch, and the ratio of the contact radius to its slope.
    branch: (Piece, f64),
    /// q = v/V.
    q: f64,
    forces: ScaledForces,
    /// The times of the joints of the law, of the peak and of the end. The motion is smooth between two of them.
    pub(super) smooth_ends: Vec<f64>,
    /// True if the stops jump at joints: under some laws, and under damping that depends on the slope.
    pub(super) has_limit_jumps: bool,
    /// True if the stops first grow in proportion to time.
    pub(super) is_smooth_at_touch: bool,
    /// Time of compression, and time from first contact to the end.
    pub(super) durations: [f64; 2],
}

impl<'a> NormalMotion<'a> {
    /// The motion at q = v/V.
    pub fn new(ground: impl Into<Surface<'a>>, q: f64, forces: &ScaledForces) -> Result<Self, IntegrationError> {
        let ground = ground.into();
        let mut recorder = TraceRecorder::default();
        let outcome = motion::integrate(ground, q, forces, &mut Rk8::new(1e-11), Some(&mut recorder))?;
        let track = recorder.into_motion(ground, outcome.unloading, forces.damping);
        let durations = [outcome.loading_time, outcome.contact_time];
        let is_published = matches!(ground.law.rule_while_loading(), UnloadingRule::Published(_));
        let is_smooth_at_touch = !is_published || ground.elastic_until() > 0.0;
        let ends = track.piece_end_times().collect();
        let (branch, peak) = (outcome.unloading.to_piece(), outcome.unloading.peak);
        let radius_per_slope = peak.force / peak.elastic_approach / branch.slope_at_distance(peak.elastic_approach);
        let (branch, forces) = ((branch, radius_per_slope), *forces);
        let mut motion = Self {
            track,
            branch,
            q,
            forces,
            smooth_ends: ends,
            has_limit_jumps: forces.damping.acts_with_slope(),
            is_smooth_at_touch,
            durations,
        };
        if is_published {
            motion.has_limit_jumps |= motion.smooth_ends.iter().any(|&end| motion.limit_jumps_at(end));
            // the stops have a kink where a dent begins to form, and where a limit of the law ceases to reduce ε
            let last_where = |from: f64, holds: &dyn Fn(&ContactState) -> bool| {
                bisect(from, durations[0], |time| motion.loading_state_at(time).is_some_and(|state| holds(&state))).0
            };
            let without_dent = last_where(0.0, &|state| state.residual() <= 0.0);
            let limited = last_where(without_dent, &|state| ground.law.limits_approach(state));
            motion.smooth_ends.extend([without_dent, limited]);
            motion.smooth_ends.sort_by(f64::total_cmp);
        }
        Ok(motion)
    }

    /// The state of the law at a time of the compression; `None` after the peak.
    fn loading_state_at(&self, time: f64) -> Option<ContactState> {
        let (at, piece) = self.track.state(time);
        piece.map(|piece| self.track.loading_point(piece, &at).state)
    }

    /// True if the stop in the middle jumps at a time.
    fn limit_jumps_at(&self, time: f64) -> bool {
        let [before, after] = [time, time + 1e-9 * self.durations[1]].map(|time| self.state_at(time).coulomb_limit);
        (before - after).abs() > 1e-6 * before
    }

    /// The motion of an elastic impact, equal for all of them in units of peak and speed.
    pub fn elastic_motion() -> Result<&'static NormalMotion<'static>, IntegrationError> {
        static ELASTIC: LazyLock<Result<NormalMotion, IntegrationError>> =
            LazyLock::new(|| NormalMotion::new(hertz_law(), 1.0, &ScaledForces::NONE));
        ELASTIC.as_ref().map_err(Clone::clone)
    }

    /// The times at which compression and the contact end.
    pub(crate) fn leg_ends(&self) -> [f64; 2] {
        self.durations
    }

    /// α and the contact force at a time.
    pub(crate) fn radius_and_force(&self, time: f64) -> [f64; 2] {
        let state = self.state_at(time);
        [state.square.sqrt(), state.force()]
    }

    /// Rim and stops at a time. The friction is limited by the whole contact force, damping included.
    ///
    /// ```text
    /// α = f/ε during loading,   α ∝ df/dx during unloading
    /// ```
    pub(super) fn state_at(&self, time: f64) -> NormalState {
        let mut rim = NormalState { time, square: 0.0, coulomb_limit: 0.0, impulse: 0.0 };
        if time <= 0.0 {
            return rim;
        }
        let (at, piece) = self.track.state(time);
        let (force, total_force, radius) = if let Some(piece) = piece {
            let TracePoint { state, total_force, .. } = self.track.loading_point(piece, &at);
            (state.force, total_force, state.force / state.elastic_approach)
        } else {
            let (branch, radius_per_slope) = &self.branch;
            let [force, slope, _] = if at.distance > 0.0 { branch.derivatives(at.distance) } else { [0.0; 3] };
            (force, total_force(self.forces.damping, force, || slope, at.speed), radius_per_slope * slope)
        };
        // on a plate or rod the sphere is faster than the approach
        let speed = at.speed + FORCE_FACTOR * self.forces.damping.plate * force;
        rim.impulse = (self.q - speed) / FORCE_FACTOR + self.forces.weight * time;
        if radius > 0.0 {
            (rim.square, rim.coulomb_limit) = (radius * radius, 1.5 * total_force / radius);
        }
        rim
    }
}
