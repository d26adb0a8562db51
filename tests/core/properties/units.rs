//! Invariants between an impact and the same impact in other units.

use plm_impact::results::NumberFormat;
use plm_impact::results::impact::{SingleImpact, impact_results};
use plm_impact::units::Dimension;

use super::balances::Judgement;
use super::random_scenario::{AnyScene, KeySetting, RefusalReason, Run};
use crate::common::prelude::*;

/// Exponents of length, time and mass.
fn exponents(dimension: Dimension) -> [i32; 3] {
    match dimension {
        Dimension::Length => [1, 0, 0],
        Dimension::Time => [0, 1, 0],
        Dimension::Speed => [1, -1, 0],
        Dimension::Acceleration => [1, -2, 0],
        Dimension::InverseSpeed => [-1, 1, 0],
        Dimension::Area => [2, 0, 0],
        Dimension::ArealNumber => [-2, 0, 0],
        Dimension::Mass => [0, 0, 1],
        Dimension::MassFlow => [0, -1, 1],
        Dimension::ArealMass => [-2, 0, 1],
        Dimension::Density => [-3, 0, 1],
        Dimension::Pressure => [-1, -2, 1],
        Dimension::Force => [1, -2, 1],
        Dimension::Energy => [2, -2, 1],
        Dimension::Stiffness | Dimension::SurfaceEnergy => [0, -2, 1],
        Dimension::AngularSpeed | Dimension::StrainRate | Dimension::Frequency => [0, -1, 0],
        Dimension::Impulse => [1, -1, 1],
        Dimension::MomentOfInertia => [2, 0, 1],
        Dimension::Viscosity => [-1, -1, 1],
        Dimension::Angle | Dimension::Ratio => [0, 0, 0],
    }
}

/// This scene in units that are larger by `factor`, in every key.
fn in_other_units(scene: &AnyScene, factor: impl Fn(Dimension) -> f64) -> AnyScene {
    let mut other = scene.clone();
    for (path, given) in &mut other.keys {
        let key = ALL_KEYS.iter().find(|key| key.path == *path);
        match given {
            KeySetting::Number(number) => *number *= factor(key.unwrap().number().unwrap().0.dimension),
            KeySetting::Points(points) => points.iter_mut().for_each(|point| point[1] *= factor(Dimension::Pressure)),
            KeySetting::Word(_) => {}
        }
    }
    // the rates that are taken where none is given
    for (path, rate, of) in [
        ("half_space.rate.johnson_cook.reference", 1.0, "half_space.rate.johnson_cook"),
        ("half_space.rate.tested_at", 1e-3, "half_space.rate"),
    ] {
        if scene.has(of) {
            other = other.with(path, KeySetting::Number(rate * factor(Dimension::StrainRate)));
        }
    }
    other
}

/// Every reported number has its unit: lengths, times and masses of another size in every key change it by the factor of its
/// dimension. Another size of all bodies, heavier ones, and stiffer ones at the same v/v_Y are such changes. In fixed steps rounding
/// may decide in which of two steps a sphere turns, so the factors are powers of four, which round nothing. In the dent of a metal
/// with a rate it decides whether a branch with a raised exponent is kept.
pub fn units_do_not_matter(run: &Run) -> Judgement {
    if run.turns_at_subdivision() || run.contact.has_rate() && run.earlier.is_some() {
        return Ok(false);
    }
    let logs = sizes_of_units(&run.scene);
    let [length, time, mass] =
        logs.map(|log| if run.is_adaptive() { 10_f64.powf(log) } else { 4_f64.powf(log.round()) });
    let factor = |dimension| {
        let [of_length, of_time, of_mass] = exponents(dimension);
        length.powi(of_length) * time.powi(of_time) * mass.powi(of_mass)
    };
    let other = match in_other_units(&run.scene, factor).run() {
        Ok(other) => other,
        // extreme units leave the range of double precision, or that of a spin, and the error says so
        Err(RefusalReason::ByImpact(ImpactError::Range(_))) => return Ok(false),
        Err(RefusalReason::ByKeys(error)) if error.to_string().contains("a spin must be") => return Ok(false),
        Err(error) => return Err(TestCaseError::fail(format!("{error:?}"))),
    };
    let is_exact = run.impact.method == Method::ClosedForm && run.contact.forces().is_none();
    let more = if run.contact.forces().is_none() { 1.0 } else { 10.0 };
    let allowed = if is_exact { 1e-12 } else { more * run.error_allowance() };
    // the weight may do nearly all of the work, of which the kinetic energy is a small part; rounding changes the lengths of the
    // steps of friction, whose runs are exact to 1e-7
    let allowed =
        if run.impact.row.has_speed() { allowed * run.input_energy() / run.impact.row.kinetic_in } else { allowed };
    let allowed = if run.impact.row.rebound.is_some() { allowed.max(1e-7) } else { allowed };
    let sizes = [run.impact.row.peak_indentation, run.impact.row.peak_force, run.input_energy()];
    let [one, two] = [run, &other].map(|run| (&run.contact, &run.impact));
    let [one, two] = [one, two].map(|(contact, impact)| SingleImpact {
        contact,
        impact,
        interval: None,
        dent_interval: None,
        notes: &[],
        drop_height: None,
        pulse: None,
    });
    let mut compared = 0;
    for result in impact_results() {
        let of_run = ["work.", "accuracy.", "verlet.", "friction_error", "energy.balance_error", "energy.angular"];
        if of_run.iter().any(|begin| result.name.starts_with(begin)) {
            continue;
        }
        let dimension = match result.format {
            NumberFormat::Unit(dimension) => dimension,
            _ if result.name.ends_with("_Pa") => Dimension::Pressure,
            _ => Dimension::Ratio,
        };
        let [got, want] = [&two, &one].map(|single| (result.value)(single));
        // a shallow dent is so flat that its curvature has lost its digits
        if result.name == "residual_radius_m"
            && run.impact.residual_radius.is_some_and(|dent| dent > 100.0 * run.impact.unloading_radius)
        {
            continue;
        }
        let (Some(got), Some(want)) = (got.as_ref().and_then(Value::as_f64), want.as_ref().and_then(Value::as_f64))
        else {
            prop_assert_eq!(got.is_some(), want.is_some(), "{}", result.name);
            continue;
        };
        // small differences of the larger sizes
        let size = match dimension {
            Dimension::Length => sizes[0].max(want.abs()),
            Dimension::Force => sizes[1].max(want.abs()),
            Dimension::Energy => sizes[2].max(want.abs()),
            Dimension::Ratio => want.abs().max(1.0),
            _ => want.abs(),
        };
        let error = (got / factor(dimension) - want).abs() / size;
        prop_assert!(
            error <= allowed || size == 0.0,
            "{}: {:e} {:e} by {:e}, off by {:e}",
            result.name,
            got,
            want,
            factor(dimension),
            error
        );
        compared += 1;
    }
    Ok(compared > 10)
}

/// Factors of the units, which are others in every scene.
fn sizes_of_units(scene: &AnyScene) -> [f64; 3] {
    let digits = |path: &str| {
        let number = scene.keys.iter().find_map(|(key, given)| match given {
            KeySetting::Number(number) if *key == path => Some(*number),
            _ => None,
        });
        // the middle digits of a random number are another one
        2.0 * (number.unwrap_or(0.5).abs() * 1e7).fract() - 1.0
    };
    [9.0 * digits("sphere.poissons_ratio"), 6.0 * digits("half_space.poissons_ratio"), 9.0 * digits("sphere.density")]
}
