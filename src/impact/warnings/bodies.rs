//! Warnings about the bodies: numbers that hardly any body has, a sphere that yields, and results that do not fit the named
//! materials. Only metals yield in the laws, and the law of a hardening metal needs more than the hardness.

use super::limits::MIN_FITTED_YIELD_STRAIN;
use crate::contact::body::{HalfSpace, Material};
use crate::contact::law::Law;
use crate::contact::pair::Pair;
use crate::impact::problem::contact::{Contact, is_modulus_wrong};
use crate::impact::result::row::ImpactRow;
use crate::impact::result::warning::{FULL_PLASTICITY_RATIO, Warning, WarningKind};
use crate::materials::{MaterialClass, MaterialEntry};
use crate::numerics::comparison::is_above;
use crate::units::{Dimension, format_four_digits, format_input, format_result};

/// Bodies of a lower density \[kg/m³\] get a warning; cork has 120 to 240.
const LOW_DENSITY: f64 = 100.0;
/// Spheres of a larger radius \[m\] get a warning.
const LARGE_RADIUS: f64 = 1.0;
/// Strengths above this fraction of Young's modulus get a warning; flawless whiskers reach a tenth.
const HIGH_STRENGTH_RATIO: f64 = 0.1;

/// The error of e from the hardness of a metal that hardens: finite elements of metals with N = 0.1 and 0.3.
pub const RESTITUTION_BIAS_TEXT: &str = "too high: by 4 to 10 % at N = 0.1, 19 to 35 % at N = 0.3";
/// The smallest and the largest of these errors.
pub const TOO_HIGH_BY: [f64; 2] = [0.04, 0.35];

/// The warnings of an impact for the materials of its bodies. With damping, the damping models the losses in the material.
pub(in crate::impact) fn material_warnings(
    contact: &Contact,
    row: &ImpactRow,
) -> impl Iterator<Item = Warning> + use<> {
    let named = contact.material_names;
    let is_elastic = contact.half_space().yield_strength.is_none();
    let is_damped = contact.forces().damping.is_some();
    let limit = if (row.restitution - 1.0).abs() < 1e-6 { "e = 1 is the elastic limit" } else { "e is an upper limit" };
    let brittle = |body: &str, entry: &MaterialEntry| {
        let text = format!(
            "{limit}, not a prediction: {body}.material = {} {}, and {} is not modelled.",
            entry.name,
            failure_mode(entry),
            failure_name(entry)
        );
        Warning::new(WarningKind::NotAMetal, 0.0, text)
    };
    let half_space = named.half_space.filter(|entry| is_elastic && !is_damped && !entry.has_strength());
    // a ball of ceramic is harder than its target
    let is_weak = |entry: &&MaterialEntry| {
        matches!(entry.class, MaterialClass::Glass | MaterialClass::Stone | MaterialClass::Polymer)
    };
    let sphere = named.sphere.filter(|entry| !is_damped && is_weak(entry));
    let hardens = |entry: &&MaterialEntry| entry.lacks_exponent || entry.has_hardening();
    let flow = contact.pair().yield_point.map(|point| point.yield_partition);
    let share = flow.map_or(0.0, |flow| flow.sphere_share);
    // a flow curve is refused if both bodies yield
    let is_of_both = flow.is_some_and(|flow| flow.is_shared());
    let metal = |place: usize, body: &str, entry: Option<&'static MaterialEntry>, share: f64| {
        let is_too_high =
            named.is_by_hardness[place] && contact.law.hardening().is_none() && row.has_dent() && share > 0.0;
        let entry = entry.filter(|entry| is_too_high && hardens(entry))?;
        let way_out = if is_of_both {
            "yield_strength at the strain of the impact, because both bodies yield"
        } else {
            "flow_stress.power.exponent (law plm)"
        };
        let text = format!(
            "e is {RESTITUTION_BIAS_TEXT}. {body}.material = {} strain-hardens, but its hardness is used without a hardening exponent N. Set {body}.{way_out}.",
            entry.name
        );
        Some(Warning::new(WarningKind::NoExponent, 0.0, text))
    };
    // near half of its melting temperature the flow stress rises two to three times with the strain rate
    let creeping = |body: &str, entry: &MaterialEntry| {
        let text = format!(
            "e is too low, and not a prediction: {body}.material = {} creeps at room temperature. Its flow stress in an impact is two to three times the flow stress from its hardness. Calibrate the strength with a measured rebound.",
            entry.name
        );
        Warning::new(WarningKind::NotAMetal, 0.0, text)
    };
    let creeps = |place: usize, entry: Option<&'static MaterialEntry>, share: f64| {
        entry.filter(|entry| entry.creeps && row.has_dent() && share > 0.0 && !named.is_of_impact[place])
    };
    let lead = [
        creeps(0, named.sphere, share).map(|entry| creeping("sphere", entry)),
        creeps(1, named.half_space, 1.0 - share).map(|entry| creeping("half_space", entry)),
    ];
    let metals = [metal(0, "sphere", named.sphere, share), metal(1, "half_space", named.half_space, 1.0 - share)];
    let brittle = [half_space.map(|entry| brittle("half_space", entry)), sphere.map(|entry| brittle("sphere", entry))];
    brittle.into_iter().chain(lead).chain(metals).flatten()
}

/// The warning for a named material that is elastic in a quasi-static indentation, although its strength may be exceeded.
pub(crate) fn elastic_material_warning(half_space: &HalfSpace, entry: &MaterialEntry) -> Option<Warning> {
    let is_elastic = half_space.yield_strength.is_none() && !entry.has_strength();
    Warning::new_if(is_elastic, WarningKind::NotAMetal, 0.0, || {
        format!(
            "No dent is computed: half_space.material = {} {}, and has no strength in the library. Set half_space.hardness to model a dent.",
            entry.name,
            failure_mode(entry)
        )
    })
}

/// The failure of a material without a strength in the library, as a noun.
fn failure_name(entry: &MaterialEntry) -> &'static str {
    match entry.class {
        MaterialClass::Metal => "flow without a hardness",
        MaterialClass::Polymer => "creep",
        _ => "cracking",
    }
}

/// How a material without a strength in the library fails.
fn failure_mode(entry: &MaterialEntry) -> &'static str {
    match entry.class {
        MaterialClass::Metal => "flows",
        MaterialClass::Polymer => "creeps",
        _ => "cracks",
    }
}

/// The body whose strength the law of a contact ignores, its partner, and this strength. This is the sphere if nothing yields by the
/// law. It is the harder body if the other body hardens, because its final strength is not known.
pub(crate) fn ignored_strength(
    pair: &Pair,
    law: &Law,
    [sphere, half_space]: [Option<f64>; 2],
) -> Option<([&'static str; 2], f64)> {
    let flow = pair.yield_point.map(|point| point.yield_partition).filter(|_| law.validity.elastic_until.is_finite());
    let of_sphere = || Some((["sphere", "half-space"], sphere?));
    let Some(flow) = flow else { return of_sphere() };
    law.hardening()?;
    if flow.is_sphere { Some((["half-space", "sphere"], half_space?)) } else { of_sphere() }
}

/// Mean pressure over yield strength, from which on a body yields.
const YIELD_PRESSURE_RATIO: f64 = 1.1;

/// The warning for a body of this strength under a mean pressure, if the law ignores the strength. `so` states the consequence for
/// the results.
pub(crate) fn yielding_warning(pressure: f64, left_out: Option<([&str; 2], f64)>, so: &str) -> Option<Warning> {
    let ([body, other], strength) = left_out.filter(|(_, strength)| pressure > YIELD_PRESSURE_RATIO * strength)?;
    let ratio = pressure / strength;
    let [peak, own] = [pressure, strength].map(|pressure| format_result(pressure, Dimension::Pressure));
    let text = if ratio > FULL_PLASTICITY_RATIO {
        format!(
            "{so}: the {body} would yield (mean pressure {peak} = {} times its yield strength {own}), but stays elastic here. Use the law plm without a flow curve of the {other}.",
            format_four_digits(ratio)
        )
    } else {
        format!(
            "{so}: the {body} would yield too, but stays elastic here. The mean pressure {peak} exceeds {YIELD_PRESSURE_RATIO} times its yield strength {own}."
        )
    };
    Some(Warning::new(WarningKind::SphereYields, ratio, text))
}

/// The warnings for a yielding sphere that is weaker than any in the finite elements, or rigid.
pub(crate) fn flow_warnings(pair: &Pair) -> impl Iterator<Item = Warning> + use<> {
    let is_rigid = pair.sphere_compliance == 0.0;
    let point = pair.yield_point.filter(|point| point.yield_partition.sphere_share > 0.0);
    let ratio = point.map_or(f64::NAN, |point| point.strength / pair.effective_modulus);
    let weak = Warning::new_if(ratio < MIN_FITTED_YIELD_STRAIN, WarningKind::WeakSphere, -ratio, || {
        format!(
            "The force is about 6 % and e about 3 % too low against finite elements: yield strength / effective modulus = {ratio:.2e} of the yielding sphere is below {MIN_FITTED_YIELD_STRAIN:.0e}."
        )
    });
    let rigid = Warning::new_if(point.is_some() && is_rigid, WarningKind::RigidFlows, 0.0, || {
        "The result is contradictory: the sphere is rigid, but yields by its yield strength. Set sphere.youngs_modulus, or remove the strength of the sphere.".to_owned()
    });
    weak.into_iter().chain(rigid)
}

/// The warnings for a sphere with numbers that hardly any body has. If the mass is given separately, the density is not checked.
pub(crate) fn sphere_warnings(
    radius: f64,
    material: &Material,
    strength: Option<f64>,
    density: Option<f64>,
) -> impl Iterator<Item = Warning> + use<> {
    let large = Warning::new_if(radius > LARGE_RADIUS, WarningKind::LargeSphere, radius, || {
        format!(
            "The result may be meaningless: sphere.radius = {radius} m is above {LARGE_RADIUS} m. Check the unit (did you mean \"5 mm\"?)."
        )
    });
    large.into_iter().chain(body_warnings("sphere", material, strength, density))
}

/// The warnings for a half-space with numbers that hardly any body has.
pub(crate) fn half_space_warnings(half_space: &HalfSpace) -> impl Iterator<Item = Warning> + use<> {
    let HalfSpace { material, yield_strength, density, .. } = half_space;
    body_warnings("half_space", material, *yield_strength, *density)
}

fn body_warnings(
    table: &str,
    material: &Material,
    strength: Option<f64>,
    density: Option<f64>,
) -> impl Iterator<Item = Warning> + use<> {
    let modulus = material.youngs_modulus;
    let high = strength.filter(|strength| is_above(*strength, HIGH_STRENGTH_RATIO * modulus)).map(|strength| {
        let [given, modulus_text] = [strength, modulus].map(|pressure| format_input(pressure, Dimension::Pressure));
        let text = if is_modulus_wrong(modulus, Some(strength)) {
            format!(
                "The result may be meaningless: {table}.youngs_modulus = {modulus_text} is far too small for a yield strength of {given}. Check the unit of the modulus (such as \"210 GPa\")."
            )
        } else {
            format!(
                "The result may be meaningless: {table}.yield_strength = {given} exceeds a tenth of Young's modulus, {modulus_text}. Check the units."
            )
        };
        Warning::new(WarningKind::HighStrength, strength / modulus, text)
    });
    let light = density.filter(|density| *density < LOW_DENSITY).map(|density| {
        let text = format!(
            "The result may be meaningless: {table}.density = {density} kg/m^3 is below {LOW_DENSITY} kg/m^3. Check the unit (such as \"7850 kg/m^3\" or \"7.85 g/cm^3\")."
        );
        Warning::new(WarningKind::LightBody, -density, text)
    });
    [high, light].into_iter().flatten()
}
