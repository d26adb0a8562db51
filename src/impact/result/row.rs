//! The results of an impact in a row of a table, a part of an [`Impact`](crate::impact::Impact).

use std::f64::consts::PI;

use crate::contact::body::{OutOfFloatRange, finite_positive};
use crate::contact::law::{ContactState, Law};
use crate::contact::pair::imprint_name;
use crate::impact::oblique::Rebound;
use crate::impact::problem::adhesion::AdhesionResult;
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
    /// The result with adhesion. `None` without a work of adhesion, for a sphere released at rest, in a viscoelastic contact, and on a
    /// plate or rod.
    pub adhesion: Option<AdhesionResult>,
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

/// Kinetic energy at first contact \[J\]. A sphere released at rest has the kinetic energy 0, which is no underflow.
fn kinetic_energy_in(contact: &Contact, speed: f64) -> Result<f64, OutOfFloatRange> {
    let is_at_rest = speed == 0.0 && !contact.forces().is_none();
    if is_at_rest {
        Ok(0.0)
    } else {
        finite_positive("kinetic energy (J)", 0.5 * contact.reduced_mass() * speed * speed)
    }
}

/// Fraction of the kinetic energy that waves carry into the half-space; `None` without a density, for a captured sphere, and for a
/// sphere released at rest.
fn wave_loss_fraction(
    contact: &Contact,
    speed: f64,
    case: &ScaledImpact,
    outcome: &ScaledResult,
) -> Result<Option<f64>, ImpactError> {
    let radiates = outcome.end == ImpactEnd::Separated && speed != 0.0;
    let Some(waves) = contact.waves().filter(|_| radiates) else { return Ok(None) };
    let ScaledImpact { scales, ground, q, forces, .. } = case;
    // the first-order estimate belongs to the impact without gravity
    let without_gravity = || closed_form::solve_energy_balance(*ground, *q).unloading;
    let unloading = if forces.weight > 0.0 { without_gravity() } else { outcome.unloading };
    Ok(Some(waves.loss_fraction(speed, scales, *ground, &unloading)?))
}

/// The state at the peak, if the numbers of this outcome are finite.
fn finite_peak(outcome: &ScaledResult) -> Result<ContactState, IntegrationError> {
    let ScaledResult { restitution, loading_time, contact_time, .. } = *outcome;
    let peak = outcome.unloading.peak;
    let is_finite = [restitution, loading_time, peak.indentation, peak.elastic_approach].iter().all(|x| x.is_finite());
    if is_finite { Ok(peak) } else { Err(IntegrationError::NotFinite { time: contact_time }) }
}

/// Fraction of the kinetic energy \[J\] that becomes plastic work, which is given in `unit` \[J\]. Under gravity the fraction may exceed 1;
/// without kinetic energy it does not exist.
fn plastic_fraction(plastic_work: f64, unit: f64, kinetic_in: f64) -> Result<f64, OutOfFloatRange> {
    let has_fraction = plastic_work != 0.0 && kinetic_in > 0.0;
    let value = if has_fraction { plastic_work * unit / kinetic_in } else { 0.0 };
    if value.is_infinite() {
        return Err(OutOfFloatRange { quantity: "plastic energy / kinetic energy", value });
    }
    Ok(value)
}

/// Height of the flight after the impact \[m\]; `None` without gravity. The flight of two bodies is not modelled.
fn rebound_height(contact: &Contact, rebound_speed: impl FnOnce() -> f64) -> Option<f64> {
    let flight = contact.forces().flight.filter(|_| contact.target_mass().is_none())?;
    Some(flight.rise_height(rebound_speed()))
}

/// Area of the dent in the half-space \[m²\]; 0 if the sphere alone yields.
fn dent_area(contact: &Contact, contact_radius: f64) -> f64 {
    let is_dented = contact.pair().yield_point.is_some_and(|point| point.yield_partition.flat_share < 1.0);
    if is_dented { PI * contact_radius * contact_radius } else { 0.0 }
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
        let ScaledImpact { scales, ground, forces, .. } = case;
        let ScaledResult { restitution, .. } = *outcome;
        let separates = outcome.end == ImpactEnd::Separated;
        let kinetic_in = kinetic_energy_in(contact, speed)?;
        let wave_loss_fraction = wave_loss_fraction(contact, speed, case, outcome)?;
        let with_waves =
            || wave_loss_fraction.map_or(restitution, |loss| waves::restitution_with_waves(restitution, loss));
        let peak = finite_peak(outcome)?;
        let peak_contact_radius = contact.contact_radius(scales, *ground, &peak)?;
        let radius_ratio = peak_contact_radius / contact.pair().smaller_radius;
        let (law, residual) = (ground.loading_law_at(peak.indentation), ground.deepest_state(&peak).residual());
        let plastic_work = ground.plastic_work(&outcome.unloading);
        let plastic_fraction = plastic_fraction(plastic_work, scales.units.energy(), kinetic_in)?;
        let contact_time = finite_positive("contact time (s)", outcome.contact_time * scales.time())?;
        let contact_time = if separates { contact_time } else { f64::INFINITY };
        let flat_share = contact.pair().yield_point.map_or(0.0, |point| point.yield_partition.flat_share);
        let subsurface_law = law.filter(|_| contact.has_subsurface && residual > 0.0);
        Ok(Self {
            restitution,
            restitution_interval: None,
            contact_time,
            peak_force: finite_positive("peak force (N)", outcome.largest_force * scales.units.force)?,
            peak_indentation: peak.indentation * scales.units.length,
            residual_indentation: residual * scales.units.length,
            flat_depth: flat_share * residual * scales.units.length,
            peak_contact_radius,
            radius_ratio,
            is_outside_validity: ground.law.validity.is_exceeded(radius_ratio)
                || law.is_some_and(|law| law.exceeded_fit_range(&peak).is_some()),
            kinetic_in,
            plastic_fraction,
            wave_loss_fraction,
            adhesion: contact.adhesion_work.filter(|_| kinetic_in > 0.0 && forces.damping.per_slope() == 0.0).map(
                |work| {
                    let dent = ground.deepest_state(&peak);
                    contact.adhesion_result(work, [speed, with_waves()], (residual > 0.0).then_some(&dent))
                },
            ),
            waveguide: WaveguideResult::from_scaled(case, outcome, contact_time),
            target_speed: contact.speeds_after(speed, restitution).1,
            rebound_height: rebound_height(contact, || with_waves() * speed).filter(|_| separates),
            strain_rate_result: contact.strain_rate_result.filter(|_| law.is_some()),
            rebound: None,
            peened: contact.peening.map(|request| PeenedSurface {
                request,
                dent_area: if residual > 0.0 { dent_area(contact, peak_contact_radius) } else { 0.0 },
                shot_mass: contact.mass(),
            }),
            subsurface: subsurface_law.and_then(|law| subsurface(contact, law, &peak, peak_contact_radius)),
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
        self.waveguide.as_ref().filter(|waveguide| waveguide.kind == kind)
    }

    /// F_m/A \[Pa\], if the target is a rod.
    pub fn rod_peak_stress(&self) -> Option<f64> {
        Some(self.peak_force / self.waveguide.as_ref()?.rod_cross_section?)
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
