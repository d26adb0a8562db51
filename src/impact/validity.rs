//! Checks of model and run. What they find is a warning in the result, and an error only with `--strict`.

use std::f64::consts::FRAC_PI_4;

use super::case::hertz;
use super::contact::Contact;
use super::oblique::{Approach, Incidence};
use super::on_plate::OnPlate;
use super::plate::{Plate, PlateTheory};
use super::result::Impact;
use super::solve::{Method, Solver};
use super::warning::{HIGH, LARGE, LIGHT, Warning};
use crate::law::{Law, Peak};
use crate::material::{HalfSpace, Material};
use crate::math::power::max_or_nan;
use crate::math::root::halved;

/// The warnings for a peak outside of the range of the law or of its flow curve.
pub(crate) fn of_peak(law: &Law, peak: &Peak) -> impl Iterator<Item = Warning> {
    let stated = law.outside_stated(peak);
    let stated = stated.map(|(from, to)| Warning::OutsideStated { indentation: peak.indentation, from, to });
    let hardening = law.hardening();
    let curve = hardening.and_then(|hardening| hardening.beyond_flow_curve(peak.indentation));
    let curve = curve.map(|(strain, last)| Warning::BeyondFlowCurve { strain, last });
    let step = hardening.and_then(|hardening| hardening.step(peak.indentation));
    let step = step.map(|(strain, ratio)| Warning::FlowStep { strain, ratio });
    let exponent = hardening.and_then(|hardening| hardening.untested_exponent(peak.indentation));
    let exponent = exponent.map(|exponent| Warning::UntestedExponent { exponent });
    stated.into_iter().chain(curve).chain(step).chain(exponent)
}

/// The warnings for a dent of this radius, over that of the sphere, which this mean pressure has made.
pub(crate) fn of_dent(law: &Law, ratio: f64, pressure: f64, strength: Option<f64>) -> impl Iterator<Item = Warning> {
    let limit = law.widest_contact();
    let deep = (ratio > limit).then_some(Warning::DeepDent { ratio, limit });
    let yields = strength.filter(|strength| pressure > 1.1 * strength);
    deep.into_iter().chain(yields.map(|strength| Warning::SphereYields { pressure, strength }))
}

/// The warnings for a sphere whose numbers hardly any body has. A mass that is not its own has no density.
pub(crate) fn of_sphere(
    radius: f64,
    material: &Material,
    strength: Option<f64>,
    density: Option<f64>,
) -> impl Iterator<Item = Warning> + use<> {
    let large = (radius > LARGE).then_some(Warning::LargeSphere { radius });
    large.into_iter().chain(of_body(["sphere.yield_strength", "sphere.density"], material, strength, density))
}

/// The warnings for a half-space whose numbers hardly any body has.
pub(crate) fn of_half_space(half_space: &HalfSpace) -> impl Iterator<Item = Warning> + use<> {
    let HalfSpace { material, yield_strength, density } = half_space;
    of_body(["half_space.yield_strength", "half_space.density"], material, *yield_strength, *density)
}

fn of_body(
    [strength_key, density_key]: [&'static str; 2],
    material: &Material,
    strength: Option<f64>,
    density: Option<f64>,
) -> impl Iterator<Item = Warning> + use<> {
    let modulus = material.youngs_modulus;
    let high = strength.filter(|strength| *strength > HIGH * modulus);
    let high = high.map(|strength| Warning::HighStrength { key: strength_key, strength, modulus });
    let light = density.filter(|density| *density < LIGHT);
    high.into_iter().chain(light.map(|density| Warning::LightBody { key: density_key, density }))
}

impl Contact {
    /// The indentation \[m\] up to which the data behind the law reach: beyond it an impact is warned of a dent that is too
    /// wide, of a flow curve that ends before, or of a law outside its stated range. Infinite for a law without such a
    /// limit, as for springs.
    pub fn deepest(&self) -> f64 {
        let radius = self.sphere().radius;
        let Some((scales, law)) = &self.yielding else {
            // Hertz: a^2 = R delta
            let limit = hertz().widest_contact();
            return limit * limit * radius;
        };
        let reaches = |x: f64| {
            let Some(peak) = law.respond(x, None).1 else { return true };
            let is_wide = scales.contact_radius * law.contact_radius(&peak) > law.widest_contact() * radius;
            let is_beyond = |warning| !matches!(warning, Warning::OutsideStated { from, .. } if x < from);
            !is_wide && !of_peak(law, &peak).any(is_beyond)
        };
        let far = radius / scales.length;
        if reaches(far) { f64::INFINITY } else { halved(0.0, far, reaches).0 * scales.length }
    }
}

/// All warnings of an impact.
pub(super) fn warnings(contact: &Contact, impact: &Impact, law: &Law, peak: &Peak, solver: &Solver) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = of_peak(law, peak).collect();
    let sphere = contact.sphere();
    let ratio = impact.peak_contact_radius / sphere.radius;
    let density = (!contact.is_of_a_body()).then_some(sphere.density);
    warnings.extend(of_sphere(sphere.radius, &sphere.material, sphere.yield_strength, density));
    warnings.extend(of_half_space(contact.half_space()));
    warnings.extend(of_dent(law, ratio, impact.peak_mean_pressure, sphere.yield_strength));
    let transit = 2.0 * sphere.radius * (sphere.density / sphere.material.youngs_modulus).sqrt();
    let transits = impact.duration() / transit;
    if transits < 5.0 && !contact.is_of_a_body() {
        warnings.push(Warning::ShortContact { transits });
    }
    let recovered = impact.restitution * impact.restitution;
    if let Some(loss) = impact.wave_loss_fraction
        && loss > 0.2 * recovered
    {
        warnings.push(Warning::StrongWaves { loss, recovered });
    }
    if contact.waves().is_some()
        && contact.forces().is_none()
        && let Some(indentation) = law.loading.jump_before(peak.indentation)
    {
        warnings.push(Warning::WavesAtJump { indentation });
    }
    if let (Some(plate), Some(of)) = (&contact.forces().plate, &impact.on_plate) {
        warnings.extend(of_plate(plate, of, impact.peak_contact_radius));
    }
    // beyond the rounding and the error of the run
    let (restitution, known) = (impact.restitution, impact.accuracy.restitution_error);
    let error = if known.is_nan() { rebound_error(contact, impact) } else { known };
    let is_real = restitution > 1.0 + 1e-12 + 10.0 * error;
    if is_real && !is_by_weight(contact, impact) {
        warnings.push(Warning::EnergyGain { restitution });
    } else if !is_real && known.is_nan() && restitution > LARGEST_ROUGH {
        warnings.push(Warning::RoughRebound { restitution, drift: impact.energy.drift });
    }
    warnings.extend(of_run(impact, solver));
    warnings
}

/// The warnings for a plate, hit with this contact radius \[m\].
fn of_plate(plate: &Plate, of: &OnPlate, contact_radius: f64) -> impl Iterator<Item = Warning> + use<> {
    let OnPlate { thinness, displacement, reach, .. } = *of;
    let thickness = plate.thickness;
    let least = match plate.theory {
        PlateTheory::Zener => 10.0,
        PlateTheory::Thick => 5.0,
    };
    let theory = match thinness {
        ..2.0 => Some(Warning::ThickPlate { thinness }),
        _ => (thinness < least).then_some(Warning::BetweenTheories { thinness, least }),
    };
    let wide = contact_radius / thickness;
    let wide = (wide > 0.15).then_some(Warning::WideContactOnPlate { ratio: wide });
    let near = plate.edge_distance.filter(|distance| *distance < reach);
    let near = near.map(|distance| Warning::NearEdge { distance, reach });
    let deep = displacement / thickness;
    let deep = (deep > 0.3).then_some(Warning::DeepPlate { ratio: deep });
    [theory, wide, near, deep].into_iter().flatten()
}

/// The warnings of an oblique impact.
pub(super) fn of_oblique(contact: &Contact, impact: &Impact, approach: Approach) -> Vec<Warning> {
    let angle = approach.incidence.map_or(0.0, |Incidence { angle, .. }| angle);
    let ratio = impact.peak_contact_radius / contact.sphere().radius;
    let ploughs = impact.has_dent() && ratio > 0.1 && angle > FRAC_PI_4;
    let mismatch = contact.mismatch();
    let slips_little = impact.rebound.is_some_and(|rebound| rebound.psi.abs() < 1.0);
    let couples = mismatch.abs() > LARGEST_MISMATCH && slips_little;
    let ploughing = ploughs.then_some(Warning::Ploughing { ratio, angle });
    ploughing.into_iter().chain(couples.then_some(Warning::Mismatch { mismatch })).collect()
}

/// Dundurs' β from which on finite elements show that it is neglected.
const LARGEST_MISMATCH: f64 = 0.25;

/// A restitution above this one is printed as more than 1.
const LARGEST_ROUGH: f64 = 1.0005;

/// A sphere that sinks into its dent may leave faster than it came by the work of gravity alone.
fn is_by_weight(contact: &Contact, impact: &Impact) -> bool {
    contact.forces().gravity.unwrap_or(0.0) > 0.0 && impact.energy.plastic.is_none_or(|plastic| plastic >= 0.0)
}

/// The error of e from the drift of the ledger, for a run without a closed form. The drift is relative to all the energy put
/// in, e to the kinetic energy of the impact.
fn rebound_error(contact: &Contact, impact: &Impact) -> f64 {
    let weight = contact.mass() * contact.forces().gravity.unwrap_or(0.0);
    impact.energy.drift * (1.0 + weight * impact.peak_indentation / impact.energy.kinetic_in)
}

/// The warning of a run that is further from the closed form than its tolerance allows or, without a closed form, of one
/// that has lost energy. Damping is not smooth at first touch, which costs the methods of `ode_solvers` up to three digits.
fn of_run(impact: &Impact, &Solver { method, tolerance, .. }: &Solver) -> Option<Warning> {
    let drift = impact.energy.drift;
    let error = max_or_nan(impact.accuracy.restitution_error, impact.accuracy.contact_time_error);
    if method == Method::Verlet {
        None
    } else if impact.accuracy.closed_form_restitution.is_nan() {
        (drift > 1000.0 * tolerance || drift.is_nan()).then_some(Warning::OpenLedger { drift, tolerance })
    } else {
        (error > 100.0 * tolerance || error.is_nan()).then_some(Warning::Inaccurate { error, tolerance })
    }
}
