//! The quantities that can be measured, and how each follows from a computed impact. They name keys of `[calibrate]`.

use super::Input;
use crate::impact::ImpactRow;
use crate::impact::flight::free_flight::FreeFlight;
use crate::scenario::keys::quantity::{FORCE, LEEB, LENGTH, RESTITUTION, SPEED, TIME};
use crate::scenario::keys::{Quantity, key};
use crate::strings::named_enum;

named_enum! {
    /// A measured quantity.
    #[derive(PartialOrd, Ord)]
    pub enum MeasuredQuantity {
        /// Rebound speed over impact speed.
        Restitution = "restitution",
        ReboundSpeed = "rebound_speed",
        ReboundHeight = "rebound_height",
        /// Time from one first touch to the next: the clicks of a bouncing ball.
        BounceInterval = "bounce_interval",
        /// Leeb hardness: 1000 times the restitution.
        Leeb = "leeb",
        /// Diameter of the dent's rim.
        DentDiameter = "dent_diameter",
        DentDepth = "dent_depth",
        ContactTime = "contact_time",
        PeakForce = "peak_force",
        /// Force of an indentation curve.
        Force = "force",
    }
}

impl MeasuredQuantity {
    /// Dimension and allowed range.
    pub fn quantity(self) -> &'static Quantity {
        match self {
            Self::Restitution => &RESTITUTION,
            Self::ReboundSpeed => &SPEED,
            Self::Leeb => &LEEB,
            Self::ReboundHeight | Self::DentDiameter | Self::DentDepth => &LENGTH,
            Self::ContactTime | Self::BounceInterval => &TIME,
            Self::PeakForce | Self::Force => &FORCE,
        }
    }

    /// True if the quantity depends only on the restitution and known keys.
    pub fn follows_from_restitution(self) -> bool {
        self <= Self::Leeb
    }

    /// The value in an impact of an input; `None` if the impact has no such value.
    pub fn predict(self, row: &ImpactRow, input: &Input) -> Option<f64> {
        match self {
            Self::DentDiameter => Some(if row.dent_depth() > 0.0 { 2.0 * row.peak_contact_radius } else { 0.0 }),
            Self::DentDepth => Some(row.dent_depth()),
            Self::ContactTime => Some(row.contact_time),
            Self::PeakForce => Some(row.peak_force),
            Self::BounceInterval => Some(row.contact_time + self.from_restitution(row.measured_restitution(), input)?),
            // elastic waves reduce the measured value, if the half-space has a density
            _ => self.from_restitution(row.measured_restitution(), input),
        }
    }

    /// The value after a rebound with this restitution; `None` if the quantity does not follow from the restitution.
    pub fn from_restitution(self, restitution: f64, input: &Input) -> Option<f64> {
        let mut speed = restitution * input.speed();
        if input.number(key!("half_space.mass")).is_some() {
            // the sphere transfers part of its speed to a free target; heights of two moving bodies are not modelled
            let [own, other] = [input.mass()?, input.half_space().free_mass()?];
            speed = (restitution * other - own) / (own + other) * input.speed();
            if matches!(self, Self::ReboundHeight | Self::BounceInterval) {
                return None;
            }
        }
        let flying = || input.free_flight().unwrap_or(FreeFlight::in_vacuum(input.drop_gravity()));
        match self {
            Self::Restitution => Some(restitution),
            Self::ReboundSpeed => Some(speed),
            Self::ReboundHeight => Some(flying().rise_height(speed)),
            // without the contact time
            Self::BounceInterval => Some(flying().rise_time(speed) + flying().fall_time(flying().rise_height(speed))),
            Self::Leeb => Some(1000.0 * restitution),
            _ => None,
        }
    }
}
