//! The normal motion as friction needs it: the radius of the contact and the stops of its springs at any time.

use std::sync::LazyLock;

use super::profile::Rim;
use crate::contact::law::{Surface, UnloadingRule};
use crate::impact::problem::forces::ScaledForces;
use crate::impact::problem::scales::ACCELERATION;
use crate::impact::scaled_impact::hertz;
use crate::impact::solve::motion;
use crate::impact::solve::recorder::{Point, Recorder, Track};
use crate::numerics::curve::piece::Piece;
use crate::numerics::ode::IntegrationError;
use crate::numerics::ode::rk8::Rk8;
use crate::numerics::power::nan_max;
use crate::numerics::root::bisect;

/// The normal motion of an impact.
#[derive(Debug)]
pub struct TangentialMotion<'a> {
    track: Track<'a>,
    /// The unloading branch, and the ratio of the contact radius to its slope.
    branch: (Piece, f64),
    /// q = v/V.
    q: f64,
    forces: ScaledForces,
    /// The times of the joints of the law, of the peak and of the end. The motion is smooth between two of them.
    pub(super) ends: Vec<f64>,
    /// True if the stops jump at joints: under some laws, and under viscous damping, which is proportional to the root of the slope.
    pub(super) jumps: bool,
    /// True if the stops first grow in proportion to time.
    pub(super) is_smooth_at_touch: bool,
    /// Time of compression, and time from first contact to the end.
    pub(super) durations: [f64; 2],
}

impl<'a> TangentialMotion<'a> {
    /// The motion at q = v/V.
    pub fn new(ground: impl Into<Surface<'a>>, q: f64, forces: &ScaledForces) -> Result<Self, IntegrationError> {
        let ground = ground.into();
        let mut recorder = Recorder::on();
        let outcome = motion::integrate(ground, q, forces, &mut Rk8::new(1e-11), &mut recorder)?;
        let track = recorder.track(ground, outcome.unloading, forces.drag);
        let durations = [outcome.loading_time, outcome.contact_time];
        let is_viscous = forces.drag.viscous != 0.0;
        let is_published = matches!(ground.law.unloading_rule, UnloadingRule::Published(_));
        let is_smooth_at_touch = !is_published || ground.elastic_until() > 0.0;
        let ends = track.ends().collect();
        let (branch, peak) = (outcome.unloading.to_piece(), outcome.unloading.peak);
        let radius_per_slope = peak.force / peak.elastic_approach / branch.slope_at_distance(peak.elastic_approach);
        let (branch, forces) = ((branch, radius_per_slope), *forces);
        let mut motion = Self { track, branch, q, forces, ends, jumps: is_viscous, is_smooth_at_touch, durations };
        if is_published {
            motion.jumps |= motion.ends.iter().any(|&end| motion.jumps_at(end));
            // from the time on at which a dent begins to form, the stops have a kink
            let (without_dent, _) = bisect(0.0, durations[0], |time| motion.is_elastic_at(time));
            motion.ends.push(without_dent);
            motion.ends.sort_by(f64::total_cmp);
        }
        Ok(motion)
    }

    /// True if a sphere that turned at this time would leave no dent.
    fn is_elastic_at(&self, time: f64) -> bool {
        let (at, piece) = self.track.state(time);
        piece.is_some_and(|piece| self.track.loading_point(piece, &at).state.residual() <= 0.0)
    }

    /// True if the stop in the middle jumps at a time.
    fn jumps_at(&self, time: f64) -> bool {
        let [before, after] = [time, time + 1e-9 * self.durations[1]].map(|time| self.rim(time).stop);
        (before - after).abs() > 1e-6 * before
    }

    /// The motion of an elastic impact, equal for all of them in units of peak and speed.
    pub fn elastic() -> Result<&'static TangentialMotion<'static>, IntegrationError> {
        static ELASTIC: LazyLock<Result<TangentialMotion, IntegrationError>> =
            LazyLock::new(|| TangentialMotion::new(hertz(), 1.0, &ScaledForces::NONE));
        ELASTIC.as_ref().map_err(Clone::clone)
    }

    /// Rim and stops at a time. The friction is limited by the whole contact force, damping included.
    ///
    /// ```text
    /// α = f/ε during loading,   α ∝ df/dx during unloading
    /// ```
    pub(super) fn rim(&self, time: f64) -> Rim {
        let mut rim = Rim { time, square: 0.0, stop: 0.0, impulse: 0.0 };
        if time <= 0.0 {
            return rim;
        }
        let (at, piece) = self.track.state(time);
        let (force, total_force, radius) = if let Some(piece) = piece {
            let Point { state, total_force, .. } = self.track.loading_point(piece, &at);
            (state.force, total_force, state.force / state.elastic_approach)
        } else {
            let (branch, radius_per_slope) = &self.branch;
            let [force, slope, _] = if at.distance > 0.0 { branch.derivatives(at.distance) } else { [0.0; 3] };
            let drag = self.forces.drag.at(force, || slope / ACCELERATION).0 * at.speed;
            (force, nan_max(force + drag, 0.0), radius_per_slope * slope)
        };
        // on a plate the sphere is faster than the approach
        let speed = at.speed + ACCELERATION * self.forces.drag.plate * force;
        rim.impulse = (self.q - speed) / ACCELERATION + self.forces.weight * time;
        if radius > 0.0 {
            (rim.square, rim.stop) = (radius * radius, 1.5 * total_force / radius);
        }
        rim
    }
}
