//! The results of an impact in a row of a table, a part of an [`Impact`](crate::impact::Impact).

use std::f64::consts::PI;

use crate::contact::body::{OutOfFloatRange, finite_positive};
use crate::contact::law::{ContactState, Law};
use crate::contact::pair::imprint_name;
use crate::impact::oblique::Rebound;
use crate::impact::problem::contact::{Contact, StrainRateResult};
use crate::impact::problem::error::ImpactError;
use crate::impact::problem::peening::PeenedSurface;
use crate::impact::problem::waveguide::WaveguideKind;
use crate::impact::problem::waves;
use crate::impact::result::subsurface::Subsurface;
use crate::impact::result::waveguide::WaveguideResult;
use crate::impact::scaled_impact::ScaledImpact;
use crate::impact::solve::closed_form;
use crate::impact::solve::outcome::{ImpactEnd, ScaledResult};
use crate::numerics::ode::IntegrationError;

/// The results of an impact in a row of a table. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactRow {
    /// e \[1\].
    pub restitution: f64,
    /// Both ends of the interval of e \[1\], which a table sets.
    pub restitution_interval: Option<[f64; 2]>,
    /// First contact to separation \[s\], by [`Method::Verlet`](crate::impact::Method::Verlet) within its last step; infinite for a
    /// captured sphere.
    pub contact_time: f64,
    /// The peak contact force \[N\], damping included.
    pub peak_force: f64,
    /// δ_m \[m\].
    pub peak_indentation: f64,
    /// δ_r \[m\]: the residual indentation, by a dent in the half-space and a flat on the sphere; 0 without both.
    pub residual_indentation: f64,
    /// The part of the residual indentation that is a flat on the sphere \[m\].
    pub flat_depth: f64,
    /// a_m \[m\]; its accuracy is given at [`Law::contact_radius`](crate::contact::law::Law::contact_radius). If there is a dent, this
    /// is the radius of its rim.
    pub peak_contact_radius: f64,
    /// a_m/R \[1\], with the radius of the smaller ball.
    pub radius_ratio: f64,
    /// True if a_m/R or δ_m is outside of the range of validity of the law, or outside of its stated range.
    pub is_outside_validity: bool,
    /// ½ m* v² \[J\]: without the motion of the centre of mass, which does not change.
    pub kinetic_in: f64,
    /// (W(δ_m) − F_m δ_e/(n + 1))/(½ m v²) \[1\]: plastic work over kinetic energy; 0 for an elastic impact.
    pub plastic_fraction: f64,
    /// Fraction of the energy that is radiated as elastic waves \[1\], to first order and without gravity. `None` if the density of the
    /// half-space is not known, under damping, on a plate or rod, and for a sphere that does not separate.
    pub wave_loss_fraction: Option<f64>,
    pub waveguide: Option<WaveguideResult>,
    /// Strain rate and factors of strength; `None` without a strain-rate dependence, and for an impact that turned in a dent.
    pub strain_rate_result: Option<StrainRateResult>,
    /// Speed \[m/s\] of a free target after the impact, normal to the surface.
    pub target_speed: Option<f64>,
    /// Rebound height \[m\], with waves and air if they are known; `None` without gravity and height, and for a sphere that does not
    /// separate.
    pub rebound_height: Option<f64>,
    /// The rebound of an oblique impact with friction. All other results then describe the motion normal to the half-space.
    pub rebound: Option<Rebound>,
    /// Dents and shots of shot peening, if asked for.
    pub peened: Option<PeenedSurface>,
    /// The state below the dent, if asked for; `None` without a dent, and if the sphere yields too.
    pub subsurface: Option<Subsurface>,
}

/// The state below a dent at this peak; `None` if the sphere yields as much, and for a law without bodies.
fn subsurface(contact: &Contact, law: &Law, peak: &ContactState, contact_radius: f64) -> Option<Subsurface> {
    let pair = contact.pair();
    let point = pair.yield_point.filter(|point| point.yield_partition.is_half_space_alone())?;
    let strength_ratio = law.hardening().map_or(1.0, |hardening| hardening.representative_strength(peak.indentation));
    (!law.is_spring()).then_some(Subsurface {
        contact_radius,
        radius_ratio: contact_radius / pair.smaller_radius,
        yield_strength: point.strength,
        strength_ratio,
        effective_modulus: pair.effective_modulus,
    })
}

impl ImpactRow {
    /// In SI units.
    #[inline(always)] // a twentieth of a row
    pub(in crate::impact) fn new(
        contact: &Contact,
        speed: f64,
        case: &ScaledImpact,
        outcome: &ScaledResult,
    ) -> Result<Self, ImpactError> {
        let ScaledImpact { scales, ground, q, forces, .. } = case;
        // a sphere released at rest has the kinetic energy 0, which is no underflow
        let kinetic_in = 0.5 * contact.reduced_mass() * speed * speed;
        let is_at_rest = speed == 0.0 && !contact.forces().is_none();
        let kinetic_in = if is_at_rest { 0.0 } else { finite_positive("kinetic energy (J)", kinetic_in)? };
        let radiating = contact.waves().filter(|_| outcome.end == ImpactEnd::Separated && !is_at_rest);
        let waves = match radiating {
            // the first-order estimate belongs to the impact without gravity
            Some(waves) if forces.weight > 0.0 => Some(waves.loss_fraction(
                speed,
                scales,
                *ground,
                &closed_form::solve_energy_balance(*ground, *q).unloading,
            )?),
            Some(waves) => Some(waves.loss_fraction(speed, scales, *ground, &outcome.unloading)?),
            None => None,
        };
        let peak = outcome.unloading.peak;
        let ScaledResult { restitution, loading_time, .. } = *outcome;
        if ![restitution, loading_time, peak.indentation, peak.elastic_approach].iter().all(|part| part.is_finite()) {
            return Err(IntegrationError::NotFinite { time: outcome.contact_time }.into());
        }
        let peak_contact_radius = contact.contact_radius(scales, *ground, &peak)?;
        let radius_ratio = peak_contact_radius / contact.pair().smaller_radius;
        let (law, residual) = (ground.loading_law_at(peak.indentation), ground.deepest_state(&peak).residual());
        let lost = ground.plastic_work(&outcome.unloading);
        // under gravity the share may exceed 1; without kinetic energy it does not exist
        let has_share = lost != 0.0 && kinetic_in > 0.0;
        let share = if has_share { lost * scales.units.energy() / kinetic_in } else { 0.0 };
        if share.is_infinite() {
            return Err(OutOfFloatRange { quantity: "plastic energy / kinetic energy", value: share }.into());
        }
        // the flight of two bodies is not modelled
        let flying = contact.forces().flight.filter(|_| contact.target_mass().is_none());
        let contact_time = finite_positive("contact time (s)", outcome.contact_time * scales.time())?;
        let contact_time = if outcome.end == ImpactEnd::Captured { f64::INFINITY } else { contact_time };
        Ok(Self {
            restitution: outcome.restitution,
            restitution_interval: None,
            contact_time,
            peak_force: finite_positive("peak force (N)", outcome.largest_force * scales.units.force)?,
            peak_indentation: peak.indentation * scales.units.length,
            residual_indentation: residual * scales.units.length,
            flat_depth: contact.pair().yield_point.map_or(0.0, |point| point.yield_partition.flat_share)
                * residual
                * scales.units.length,
            peak_contact_radius,
            radius_ratio,
            is_outside_validity: radius_ratio > ground.law.validity.max_radius_ratio
                || law.is_some_and(|law| law.exceeded_fit_range(&peak).is_some()),
            kinetic_in,
            plastic_fraction: share,
            wave_loss_fraction: waves,
            waveguide: WaveguideResult::from_scaled(case, outcome, contact_time),
            target_speed: contact.speeds_after(speed, outcome.restitution).1,
            rebound_height: flying.filter(|_| outcome.end == ImpactEnd::Separated).map(|flying| {
                let restitution =
                    waves.map_or(outcome.restitution, |loss| waves::restitution_with_waves(outcome.restitution, loss));
                flying.rise_height(restitution * speed)
            }),
            strain_rate_result: contact.strain_rate_result.filter(|_| law.is_some()),
            rebound: None,
            peened: contact.peening.map(|request| {
                let is_dented = contact.pair().yield_point.is_some_and(|point| point.yield_partition.flat_share < 1.0);
                let dent_area =
                    if is_dented && residual > 0.0 { PI * peak_contact_radius * peak_contact_radius } else { 0.0 };
                PeenedSurface { request, dent_area, shot_mass: contact.mass() }
            }),
            subsurface: law
                .filter(|_| contact.has_subsurface && residual > 0.0)
                .and_then(|law| subsurface(contact, law, &peak, peak_contact_radius)),
        })
    }

    /// Depth of the dent in the half-space \[m\].
    pub fn dent_depth(&self) -> f64 {
        self.residual_indentation - self.flat_depth
    }

    /// True if the impact left a flat on the sphere.
    pub fn has_flat(&self) -> bool {
        self.flat_depth > 0.0
    }

    /// The imprint of the impact: `dent`, `flat`, or `dent and flat`.
    pub fn imprint_name(&self) -> &'static str {
        imprint_name(self.flat_depth / self.residual_indentation)
    }

    /// True if the impact left a dent or a flat.
    pub fn has_dent(&self) -> bool {
        self.residual_indentation > 0.0
    }

    /// True if the sphere arrived with a speed. A sphere released at first contact has no restitution and no kinetic energy to refer
    /// fractions to.
    pub fn has_speed(&self) -> bool {
        self.kinetic_in > 0.0
    }

    /// The results of a waveguide of this kind, if the target is one.
    pub fn waveguide_of(&self, kind: WaveguideKind) -> Option<&WaveguideResult> {
        self.waveguide.as_ref().filter(|waveguide| waveguide.guide.kind() == kind)
    }

    /// F_m/A \[Pa\], if the target is a rod.
    pub fn rod_peak_stress(&self) -> Option<f64> {
        let rod = *self.waveguide.as_ref()?.guide.rod()?;
        Some(self.peak_force / rod.cross_section())
    }

    /// Fraction of the kinetic energy that a waveguide of this kind absorbs \[1\].
    pub fn waveguide_loss_fraction(&self, kind: WaveguideKind) -> Option<f64> {
        self.waveguide_of(kind).filter(|_| self.has_speed()).map(|waveguide| waveguide.energy / self.kinetic_in)
    }

    /// (e v)²/v² \[1\]: recovered fraction of the kinetic energy.
    pub fn recovered_fraction(&self) -> f64 {
        self.restitution * self.restitution
    }

    /// e with the loss by waves \[1\]; 0 if the waves would absorb more than the recovered energy.
    pub fn restitution_with_waves(&self) -> Option<f64> {
        self.wave_loss_fraction.map(|loss| waves::restitution_with_waves(self.restitution, loss))
    }

    /// The restitution that a measurement finds: with waves if they are known.
    pub fn measured_restitution(&self) -> f64 {
        self.restitution_with_waves().unwrap_or(self.restitution)
    }
}
