//! The input of one impact: its units, law, dimensionless speed and forces.

use std::sync::LazyLock;

use super::problem::contact::Contact;
use super::problem::error::ImpactError;
use super::problem::forces::ScaledForces;
use super::problem::scales::{FORCE_FACTOR, Scales, kinetic_energy};
use super::problem::waveguide::ScaledWaveguide;
use super::solve::undamped_contact_time;
use crate::contact::body::finite_positive;
use crate::contact::law::{Law, LoadingHistory, Surface};
use crate::numerics::ode::DampingCoefficients;

/// The input of one impact.
#[derive(Debug, Clone, Copy)]
pub(super) struct ScaledImpact<'a> {
    pub(super) scales: Scales,
    pub(super) ground: Surface<'a>,
    /// v/V.
    pub(super) q: f64,
    pub(super) forces: ScaledForces,
    pub(super) waveguide: Option<ScaledWaveguide>,
}

impl Contact {
    /// Units, law and dimensionless speed of an impact. In these units all elastic impacts are equal.
    ///
    /// # Errors
    /// [`ImpactError::Range`] if peak force, indentation or energy leave double precision.
    pub fn scaling(&self, speed: f64) -> Result<(Scales, &Law, f64), ImpactError> {
        let ScaledImpact { scales, ground, q, .. } = self.scaled_impact(None, speed)?;
        Ok((scales, ground.law, q))
    }

    /// The impact at a speed. On a spot with a dent, the units are the units of the yield point. Under gravity the speed may be 0: the
    /// sphere is released at rest.
    #[inline(always)]
    pub(super) fn scaled_impact<'a>(
        &'a self,
        dent: Option<&'a LoadingHistory>,
        speed: f64,
    ) -> Result<ScaledImpact<'a>, ImpactError> {
        self.forces().check()?;
        let gravity = self.forces().gravity.unwrap_or(0.0);
        if gravity > 0.0 && self.target_mass().is_some() {
            return Err(ImpactError::FreeUnderGravity);
        }
        let weight = self.mass() * gravity;
        // damping, plate and rod remove energy: an impact that is elastic without them is elastic with them
        let with_weight = || {
            let (q, least) = (speed / self.scales.speed, self.elastic_speed / self.scales.speed);
            let until = self.law.recovers_fully_until();
            // a law without an elastic regime yields at once
            until == 0.0 || kinetic_energy(q) + weight / self.scales.units.force * until > kinetic_energy(least)
        };
        let (scales, ground, q) = if dent.is_some() || speed > self.elastic_speed || weight > 0.0 && with_weight() {
            let q = speed / self.scales.speed;
            let quantity = match gravity {
                0.0 => "kinetic energy in units of that at first yield",
                _ => "kinetic energy and weight in units of those at first yield",
            };
            let weight = weight / self.scales.units.force;
            finite_positive(quantity, q * q + weight)?;
            (self.scales, Surface::hit_with(&self.law, dent, kinetic_energy(q), weight), q)
        } else {
            let scales = Scales::from_hertz_impact(self.pair(), self.reduced_mass(), speed, gravity)?;
            (scales, hertz_law().into(), speed / scales.speed)
        };
        if self.forces().is_none() {
            return Ok(ScaledImpact { scales, ground, q, forces: ScaledForces::NONE, waveguide: None });
        }
        let drag =
            self.forces().damping.map_or(DampingCoefficients::NONE, |damping| damping.scaled_coefficients(&scales));
        let mut forces = ScaledForces { weight: weight / scales.units.force, damping: drag };
        let mut waveguide = None;
        if let Some(under) = self.contact_waveguide()? {
            let free_time = undamped_contact_time(ground, q, &forces)? * scales.time();
            let scaled = under.to_scaled(speed, self.pair().hertz_stiffness(), &scales, free_time)?;
            forces.damping.plate = scaled.mobility / FORCE_FACTOR;
            waveguide = Some(scaled);
        }
        Ok(ScaledImpact { scales, ground, q, forces, waveguide })
    }
}

/// Hertz without limit: the law of every impact that stays elastic, in its own units.
pub(super) fn hertz_law() -> &'static Law {
    static HERTZ: LazyLock<Law> = LazyLock::new(Law::hertz);
    &HERTZ
}
