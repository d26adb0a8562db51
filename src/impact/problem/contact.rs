//! The part of an impact that does not depend on its speed: bodies, law, scales, gravity and damping.

use std::sync::Arc;

use super::error::ImpactError;
use super::forces::Forces;
use super::peening::Peening;
use super::scales::Scales;
use super::waveguide::{ContactWaveguide, WaveguideError, WaveguideFault};
use super::waves::Waves;
use crate::contact::body::{HalfSpace, Material, Sphere, Support, finite_positive};
use crate::contact::law::{ContactLaw, ContactState, Law, LawChoice, Surface};
use crate::contact::pair::Pair;
use crate::contact::strength::strain_rate_hardening::StrainRateHardening;
use crate::materials::MaterialEntry;
use crate::numerics::functions::pow;

/// The materials of the bodies that have a named material.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MaterialNames {
    /// The material of the sphere, if it is named.
    pub sphere: Option<&'static MaterialEntry>,
    /// The material of the half-space, if it is named.
    pub half_space: Option<&'static MaterialEntry>,
    /// True if the strengths of sphere and half-space come from their hardness, without a hardening exponent.
    pub is_by_hardness: [bool; 2],
    /// True if the strengths of sphere and half-space hold for the impact itself, such as calibrated strengths.
    pub is_of_impact: [bool; 2],
}

/// How the strengths of the bodies rise with the strain rate, and the law that uses them.
#[derive(Debug, Clone)]
pub(in crate::impact) struct RateDependence {
    /// The strain-rate hardening of sphere and half-space.
    pub(in crate::impact) of_bodies: [Option<StrainRateHardening>; 2],
    pub(in crate::impact) law: LawChoice,
}

/// The strain rate of an impact, and the factors by which it raises the strength; `strain_rate.rs` computes them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrainRateResult {
    /// 0.2 w \[1/s\].
    pub strain_rate: f64,
    /// g of the yielding body; if both bodies yield, the mean of both weighted by their fractions of the yielding.
    pub factor: f64,
    /// g_t, at maximum compression.
    pub factor_at_peak: f64,
    /// The strain-rate hardening; `None` if the body with a strain-rate dependence does not yield.
    pub(in crate::impact) rate: Option<StrainRateHardening>,
}

/// A sphere, a half-space and the law between them: everything that does not depend on the impact speed.
#[derive(Debug, Clone)]
pub struct Contact {
    sphere: Sphere,
    half_space: HalfSpace,
    pair: Pair,
    /// Mass of the sphere \[kg\].
    mass: f64,
    /// Mass of a half-space that is free to move \[kg\].
    target_mass: Option<f64>,
    /// m* \[kg\]: the reduced mass.
    reduced_mass: f64,
    /// True if the sphere is only the tip of a body, and the mass is the mass of this body.
    has_attached_mass: bool,
    pub(in crate::impact) law: Law,
    /// The units of first yield, or of the radius of the sphere for bodies that stay elastic.
    pub(in crate::impact) scales: Scales,
    /// Speed of the slowest impact that yields \[m/s\]; infinite if no impact yields.
    pub(in crate::impact) yield_speed: f64,
    /// Speed of the fastest impact without any loss \[m/s\]: the yield speed, or less if the metal relaxes.
    pub(in crate::impact) elastic_speed: f64,
    /// How the strengths rise with the strain rate.
    pub(in crate::impact) rate_dependence: Option<Arc<RateDependence>>,
    /// The strain rate of the strength of this contact; `None` without a strain-rate dependence, and before a speed is known.
    pub(in crate::impact) strain_rate_result: Option<StrainRateResult>,
    /// 8 G* \[Pa\]: the stiffness of the contact against a slip, over the contact radius.
    pub(in crate::impact) friction_modulus: f64,
    forces: Forces,
    /// The radiation of the half-space, if its density is known.
    waves: Option<Waves>,
    /// Moment of inertia of all moving parts about the centre of the sphere \[kg m²\]; `None` for a solid sphere.
    moment_of_inertia: Option<f64>,
    /// The materials of the bodies, if they are named.
    pub(in crate::impact) material_names: MaterialNames,
    /// w \[J/m²\], if the restitution with adhesion is asked for.
    pub(in crate::impact) adhesion_work: Option<f64>,
    /// The request of shot peening.
    pub(in crate::impact) peening: Option<Peening>,
    /// True if the plastic zone and the residual stress below the dent are asked for.
    pub(in crate::impact) has_subsurface: bool,
}

/// Below this modulus \[Pa\] the modulus is wrong, and not the strength: soft rubber is stiffer.
const SOFT: f64 = 1e5;
/// No metal and hardly a ceramic has a larger strength \[Pa\].
const STRONG: f64 = 1e10;

/// Whether Young's modulus is the wrong number, and not the strength beside the modulus: no solid has this modulus, or the
/// modulus is below a strength that a solid has.
pub(in crate::impact) fn is_modulus_wrong(modulus: f64, strength: Option<f64>) -> bool {
    modulus < SOFT || strength.is_some_and(|strength| modulus < strength && strength < STRONG)
}

/// 1/G* \[1/Pa\] = 2 (1 + ν)(2 − ν)/E, summed over both bodies.
pub(in crate::impact) fn shear_compliance(sphere: &Sphere, half_space: &HalfSpace) -> f64 {
    let share = |body: &Material| 2.0 * (1.0 + body.poissons_ratio) * (2.0 - body.poissons_ratio) / body.youngs_modulus;
    share(&sphere.material) + share(&half_space.material)
}

/// A rebound slower than this fraction of the impact speed is the error of an integration, and counts as rest.
const AT_REST: f64 = 1e-10;

impl Contact {
    /// Pairs the bodies under a law (or Hertz alone, for a half-space without a yield strength).
    ///
    /// # Errors
    /// [`ImpactError::Range`] if a constant of the pair over- or underflows, [`ImpactError::Law`] for a law that has no
    /// loading or no unloading (see [`Combined`](crate::contact::law::Combined)).
    pub fn try_new(sphere: Sphere, half_space: HalfSpace, law: &dyn ContactLaw) -> Result<Self, ImpactError> {
        let mass = finite_positive("sphere mass (kg)", sphere.mass())?;
        let target_mass = half_space
            .free_mass()
            .map(|mass| finite_positive("mass of the body that is hit (kg)", mass))
            .transpose()?;
        let reduced_mass = match target_mass {
            Some(target) => finite_positive("reduced mass (kg)", mass * (target / (mass + target)))?,
            None => mass,
        };
        let pair = Pair::try_new(&sphere, &half_space)?;
        let waves = if half_space.support == Support::Fixed { Waves::try_new(&half_space)? } else { None };
        let (scales, law, yield_speed) = Self::build_law(&pair, reduced_mass, law)?;
        let friction_modulus = 8.0 / shear_compliance(&sphere, &half_space);
        Ok(Self {
            sphere,
            half_space,
            pair,
            mass,
            target_mass,
            reduced_mass,
            has_attached_mass: false,
            law,
            scales,
            yield_speed,
            elastic_speed: yield_speed,
            rate_dependence: None,
            strain_rate_result: None,
            friction_modulus,
            forces: Forces::default(),
            waves,
            moment_of_inertia: None,
            material_names: MaterialNames::default(),
            adhesion_work: None,
            peening: None,
            has_subsurface: false,
        })
    }

    /// The scales, the law and the yield speed of a pair.
    fn build_law(pair: &Pair, mass: f64, law: &dyn ContactLaw) -> Result<(Scales, Law, f64), ImpactError> {
        let (scales, law) = (Scales::from_pair(pair, mass)?, law.law_for_pair(pair)?);
        // up to this x the contact is Hertz's, ½ m v² = W = (2/5) x^2.5 in units of F_Y δ_Y
        let until = law.validity.elastic_until;
        let yield_speed = if until == 1.0 { scales.speed } else { scales.speed * pow(until, 1.25) };
        Ok((scales, law, yield_speed))
    }

    /// This contact with the strengths of another pair of the same bodies. No strain rate raises these strengths.
    pub(in crate::impact) fn with_pair(&self, pair: Pair, law: &dyn ContactLaw) -> Result<Self, ImpactError> {
        let (scales, law, yield_speed) = Self::build_law(&pair, self.reduced_mass, law)?;
        Ok(self.with_law(pair, law, scales, yield_speed))
    }

    /// This contact with another pair of the same bodies, and with the law, the scales and the yield speed of this pair.
    pub(in crate::impact) fn with_law(&self, pair: Pair, law: Law, scales: Scales, yield_speed: f64) -> Self {
        let elastic_speed = yield_speed;
        Self { pair, law, scales, yield_speed, elastic_speed, rate_dependence: None, strain_rate_result: None, ..*self }
    }

    /// Returns this contact with a body that has this moment of inertia about the sphere's centre \[kg m²\].
    #[inline]
    pub fn with_moment_of_inertia(mut self, moment: f64) -> Self {
        self.moment_of_inertia = Some(moment);
        self
    }

    /// The moment of inertia \[kg m²\]; `None` for a solid sphere.
    pub fn moment_of_inertia(&self) -> Option<f64> {
        self.moment_of_inertia
    }

    /// Returns this contact with gravity and damping, or on a waveguide.
    #[inline]
    pub fn with_forces(mut self, forces: Forces) -> Self {
        self.forces = forces;
        self
    }

    /// Returns this contact with the names of its materials, which some warnings need.
    #[inline]
    pub fn with_materials(mut self, named: MaterialNames) -> Self {
        self.material_names = named;
        self
    }

    /// Largest contact radius over the radius of the smaller body up to which the law is validated.
    pub fn max_radius_ratio(&self) -> f64 {
        self.law.validity.max_radius_ratio
    }

    /// Returns this contact with a work of adhesion \[J/m²\], from which the restitution with adhesion follows.
    #[inline]
    pub fn with_adhesion(mut self, work: Option<f64>) -> Self {
        self.adhesion_work = work;
        self
    }

    /// The work of adhesion \[J/m²\], if it is given.
    pub fn adhesion_work(&self) -> Option<f64> {
        self.adhesion_work
    }

    /// Returns this contact with results of shot peening.
    #[inline]
    pub fn with_peening(mut self, peening: Option<Peening>) -> Self {
        self.peening = peening;
        self
    }

    /// Returns this contact with the plastic zone and the residual stress below the dent among the results, if they are asked for.
    #[inline]
    pub fn with_subsurface(mut self, is_asked_for: bool) -> Self {
        self.has_subsurface = is_asked_for;
        self
    }

    /// Returns this contact with the sphere as the tip of the moving body. The wave speed of this body is not known.
    #[inline]
    pub(crate) fn with_attached_mass(mut self) -> Self {
        self.has_attached_mass = true;
        self
    }

    /// True if the sphere is only the tip of the moving body.
    pub(crate) fn has_attached_mass(&self) -> bool {
        self.has_attached_mass
    }

    pub fn sphere(&self) -> &Sphere {
        &self.sphere
    }

    pub fn half_space(&self) -> &HalfSpace {
        &self.half_space
    }

    pub fn pair(&self) -> &Pair {
        &self.pair
    }

    pub fn forces(&self) -> &Forces {
        &self.forces
    }

    pub(in crate::impact) fn contact_waveguide(&self) -> Result<Option<ContactWaveguide>, WaveguideError> {
        let Some(guide) = self.forces.waveguide else { return Ok(None) };
        let refuse = |reason| Err(WaveguideError { kind: guide.kind(), reason });
        match self.forces.damping {
            _ if self.half_space.radius.is_some() || self.target_mass.is_some() => refuse(WaveguideFault::Curved),
            Some(_) => refuse(WaveguideFault::Damped),
            None => ContactWaveguide::new(guide, &self.half_space, self.mass, &self.scales, &self.law).map(Some),
        }
    }

    /// Checks the plate or rod of this contact, if it has one, for everything that does not depend on the speed.
    pub fn check_waveguide(&self) -> Result<(), WaveguideError> {
        self.contact_waveguide().map(drop)
    }

    /// The radiation of elastic waves from the half-space. `None` if its density is not known or it is free to move; under damping, as
    /// the force then is not the force of the law; and on a plate or rod, which absorbs energy in another way.
    pub fn waves(&self) -> Option<&Waves> {
        self.waves.as_ref().filter(|_| !self.forces.has_dissipation())
    }

    /// True if the law has a flow curve of the yielding body.
    pub fn has_hardening(&self) -> bool {
        self.law.hardening().is_some()
    }

    /// The contact radius at a peak \[m\].
    ///
    /// # Errors
    /// [`ImpactError::TooDeep`] if the radius or the indentation is larger than the radius of the sphere, or of a smaller ball.
    pub(in crate::impact) fn contact_radius(
        &self,
        scales: &Scales,
        ground: Surface,
        peak: &ContactState,
    ) -> Result<f64, ImpactError> {
        let (indentation, radius) = (peak.indentation * scales.units.length, self.pair.smaller_radius);
        let contact_radius = scales.units.contact_radius * ground.contact_radius(peak);
        // a spring has no geometry, but its sphere has a radius
        let is_too_wide = contact_radius > radius && !ground.law.is_spring();
        if indentation > radius || is_too_wide {
            let softer = self.pair.yield_point.map(|point| point.yield_partition.is_sphere);
            let yield_strength = self.half_space.yield_strength.filter(|_| softer == Some(false));
            let moduli = [
                ("sphere", self.sphere.material, self.sphere.yield_strength),
                ("half_space", self.half_space.material, self.half_space.yield_strength),
            ];
            let wrong_modulus = moduli
                .into_iter()
                .map(|(table, material, strength)| (table, material.youngs_modulus, strength))
                .find(|(_, modulus, strength)| is_modulus_wrong(*modulus, *strength))
                .map(|(table, modulus, _)| (table, modulus));
            return Err(ImpactError::TooDeep { indentation, contact_radius, radius, yield_strength, wrong_modulus });
        }
        Ok(contact_radius)
    }

    /// Mass of the sphere \[kg\].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Mass \[kg\] of a target that is free to move.
    pub fn target_mass(&self) -> Option<f64> {
        self.target_mass
    }

    /// m* \[kg\]: the reduced mass of the relative motion; the mass of the sphere if the other body is fixed.
    pub fn reduced_mass(&self) -> f64 {
        self.reduced_mass
    }

    /// Speeds \[m/s\] after an impact at this closing speed. The speed of the sphere is positive if it moves back, and negative if it
    /// continues in its direction. The speed of a free target is positive in the direction of the approach.
    #[inline]
    pub fn speeds_after(&self, speed: f64, restitution: f64) -> (f64, Option<f64>) {
        let Some(target) = self.target_mass else { return (restitution * speed, None) };
        let both = self.mass + target;
        let share = (restitution * target - self.mass) / both;
        // two equal elastic balls: the remaining speed is the error of e
        let rebound = if share.abs() < AT_REST { 0.0 } else { share * speed };
        (rebound, Some((1.0 + restitution) * (self.mass / both) * speed))
    }

    /// The slowest impact that yields by the law \[m/s\], v_Y for the PLM; `None` for a contact that stays elastic, for a law
    /// without an elastic regime, and where the contact would be wider than the sphere at first yield.
    pub fn yield_speed(&self) -> Option<f64> {
        let is_speed = self.yield_speed > 0.0 && self.yield_speed.is_finite();
        (is_speed && self.reaches_first_yield()).then_some(self.yield_speed)
    }

    /// False if the contact would be wider than the sphere at first yield by the law, so that the law has no first yield. The
    /// pressure of a law at first yield may be another than that of von Mises for the yield strength.
    pub fn reaches_first_yield(&self) -> bool {
        let until = self.law.validity.elastic_until;
        until.is_infinite() || self.scales.units.contact_radius * until.sqrt() < self.pair.smaller_radius
    }

    /// True if the law is a pair of springs, which leave no dent.
    pub fn is_spring(&self) -> bool {
        self.law.is_spring()
    }

    /// Indentation \[m\] and force \[N\] at which the contact yields by the law; `None` like [`Contact::yield_speed`].
    pub fn yield_indentation_and_force(&self) -> Option<(f64, f64)> {
        self.yield_speed()?;
        let until = self.law.validity.elastic_until;
        Some((self.scales.units.length * until, self.scales.units.force * crate::numerics::power::power(until, 1.5)))
    }
}
