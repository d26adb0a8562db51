//! The normal motion as friction sees it: the radius of the contact and the stops of its springs at any time.

use std::sync::LazyLock;

use super::profile::Rim;
use crate::contact::law::Ground;
use crate::impact::case::hertz;
use crate::impact::course;
use crate::impact::forces::ScaledForces;
use crate::impact::record::{Recorder, Track};
use crate::numerics::integrate::IntegrationError;
use crate::numerics::integrate::rk8::Rk8;

/// The normal motion of an impact.
#[derive(Debug)]
pub struct TangentialMotion<'a> {
    track: Track<'a>,
    /// The times of the joints of the law, of the peak and of the end; each stretch between two of them is smooth.
    pub(super) ends: Vec<f64>,
    /// Whether the stops jump at joints: viscous damping goes with the root of the slope.
    pub(super) jumps: bool,
    /// Time of compression, and from first touch to the end.
    pub(super) durations: [f64; 2],
}

impl<'a> TangentialMotion<'a> {
    /// The motion at q = v/V.
    pub fn new(ground: impl Into<Ground<'a>>, q: f64, forces: &ScaledForces) -> Result<Self, IntegrationError> {
        let ground = ground.into();
        let mut recorder = Recorder::on();
        let outcome = course::integrate(ground, q, forces, &mut Rk8::new(1e-11), &mut recorder)?;
        let track = recorder.track(ground, outcome.unloading, forces.drag);
        let durations = [outcome.loading_time, outcome.contact_time];
        Ok(Self { ends: track.ends().collect(), jumps: forces.drag.eta != 0.0, durations, track })
    }

    /// The motion of an elastic impact. It is one for all of them in units of its own peak and speed.
    pub fn elastic() -> Result<&'static TangentialMotion<'static>, IntegrationError> {
        static ELASTIC: LazyLock<Result<TangentialMotion, IntegrationError>> =
            LazyLock::new(|| TangentialMotion::new(hertz(), 1.0, &ScaledForces::NONE));
        ELASTIC.as_ref().map_err(Clone::clone)
    }

    /// Rim and stops at a time. The friction is limited by the whole contact force, damping included.
    ///
    /// ```text
    /// α = f/ε on the way in,   α ∝ df/dx on the way out
    /// ```
    pub(super) fn rim(&self, time: f64) -> Rim {
        let none = Rim { time, square: 0.0, stop: 0.0 };
        if time <= 0.0 {
            return none;
        }
        let point = self.track.at(time);
        let (force, approach) = (point.state.force, point.state.elastic_approach);
        let radius =
            if point.is_unloading { self.track.unloading().radius_ratio(approach.max(0.0)) } else { force / approach };
        if radius > 0.0 {
            Rim { square: radius * radius, stop: 1.5 * point.total_force / radius, ..none }
        } else {
            none
        }
    }
}
